"""All runs of a unit: the loop of the exhaustive check."""

from __future__ import annotations

import time
from collections.abc import Iterator, MutableSequence
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any, Protocol

from allworlds.engines.python.examiner import Examiner, Outcome, Referee, name_run
from allworlds.engines.python.runs_of_unit import NumberedRun, UnitOfRuns, numbered_runs
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.tally import AtRun, Tally
from allworlds.explorers import Subject
from allworlds.maps import rooted_code
from allworlds.world import World

if TYPE_CHECKING:
    from allworlds.engines.python.second_play import EarlierPlays, Players

REPORT_EVERY = 0.25
"""Seconds after which a part of a unit is handed over."""


class EnginesDisagree(Exception):
    """Two engines differ about one world."""


class PartwiseEngine(Protocol):
    """An engine with its explorer, which does a unit from some run on."""

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Any]]:
        """The number of the next run and the result since, now and then and at the end."""


@dataclass(frozen=True, slots=True)
class PythonEngine:
    """The engine in which every run of a unit is played, judged and tallied in Python.

    Attributes:
        scope: what is checked, and under which rules.
        keep: how many findings are kept.
    """

    scope: Scope
    keep: int

    def for_built_in(
        self, subject: Subject, beat: MutableSequence[int] | None = None
    ) -> PartwiseEngine:
        """The engine with an explorer of ours, which is played in this process, and once.

        Args:
            subject: the explorer.
            beat: see :func:`allworlds.judging.episode.play`.
        """
        return BoundPythonEngine(self, subject, beat)

    def for_foreign(
        self, explorer: str, players: Players, earlier: EarlierPlays[Any]
    ) -> PartwiseEngine:
        """The engine with a foreign explorer, of that name, which plays everything twice.

        Args:
            explorer: its name.
            players: its players.
            earlier: plays of other units, to be played again.
        """
        from allworlds.engines.python.second_play import PlayedTwice

        return PlayedTwice(self, explorer, players, earlier)

    def runs(self, unit: UnitOfRuns, start: int = 0) -> Iterator[NumberedRun]:
        """The runs of a unit from that number on."""
        every = numbered_runs(unit, self.scope.extent, self.scope.rules.kind)
        return islice(every, start, None)

    def tally(self) -> Tally:
        """An empty tally."""
        return Tally(self.keep)

    def count_run(self, run: NumberedRun, tally: Tally) -> World | None:
        """Count a run, and return its world; None where that has no place for the lighthouse."""
        edges, vertices = run.map.edge_count, run.map.vertex_count
        if run.first:
            tally.row(edges, vertices).worlds += 1
            if run.map.loop_count:
                tally.witnesses["loop-edge"] += 1
            if run.map.parallel_count:
                tally.witnesses["parallel-edge"] += 1
        if run.lighthouse is None:
            tally.left_out += 1
            return None
        tally.row(edges, vertices).runs += 1
        return World(run.map, run.lighthouse, 0)

    def count_outcome(
        self, referee: Referee, world: World, place: int, outcome: Outcome, tally: Tally
    ) -> None:
        """Add one episode of a run to the tally."""
        edges, vertices = world.map.edge_count, world.map.vertex_count
        row, cost = tally.row(edges, vertices), outcome.cost
        row.episodes += 1
        row.traversals += cost
        if place == 0:
            row.traversals_rooted += cost
        if cost >= row.max_cost:
            code = rooted_code(world.map.sigma, world.map.alpha, 0)
            row.cost_of(cost, AtRun(*code, place, outcome.choices))
        row.bound_of(outcome.bound)
        tally.checkpoints += len(outcome.episode.checkpoints)
        if outcome.violation and tally.wants(edges, vertices):
            tally.find(referee.finding(world, place, outcome))


@dataclass(frozen=True, slots=True)
class BoundPythonEngine:
    """The Python engine with an explorer of ours, which is played here, and once."""

    engine: PythonEngine
    subject: Subject
    beat: MutableSequence[int] | None = None

    def parts(self, unit: UnitOfRuns, start: int = 0) -> Iterator[tuple[int, Tally]]:
        """The number of the next run and the tally since, after some time and at the end."""
        engine, scope = self.engine, self.engine.scope
        examiner = Examiner(self.subject, scope.rules, self.beat)
        tally, after = engine.tally(), start
        due = time.monotonic() + REPORT_EVERY
        for run in engine.runs(unit, start):
            after = run.number + 1
            world = engine.count_run(run, tally)
            if world is not None:
                for choices in scope.schedule(name_run(scope.rules, world)):
                    outcome = examiner.examine(world, choices)
                    engine.count_outcome(examiner, world, run.place, outcome, tally)
                tally.witnesses.update(examiner.events)
                examiner.events.clear()
            if time.monotonic() > due:
                yield after, tally
                tally = engine.tally()
                due = time.monotonic() + REPORT_EVERY
        yield after, tally
