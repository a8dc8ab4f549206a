"""All runs of a unit, one after the other: the loop of the exhaustive check."""

from __future__ import annotations

import time
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Any, Protocol

from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.runs.examiner import Examiner, make_finding
from allworlds.runs.scope import Scope
from allworlds.runs.tally import Tally
from allworlds.runs.units import Worlds, numbered_runs
from allworlds.subjects import Subject
from allworlds.world import World

REPORT_EVERY = 0.25
"""Seconds after which a part of a unit is handed over."""


class Examines(Protocol):
    """What a worker can do with a unit, whatever comes of it.

    Attributes:
        scope: for its rules, and to name a run.
        keep: how many findings are kept.
    """

    @property
    def scope(self) -> Scope:
        """See above."""

    @property
    def keep(self) -> int:
        """See above."""

    def parts(
        self, examiner: Examiner, unit: Worlds, start: int = 0, skip: Collection[int] = ()
    ) -> Iterator[tuple[int, Any]]:
        """See :meth:`Examination.parts`."""


@dataclass(frozen=True, slots=True)
class Examination:
    """What is done with a unit: every run of it played, judged and tallied.

    Attributes:
        scope: what is checked, and under which rules.
        keep: how many findings are kept.
    """

    scope: Scope
    keep: int

    def parts(
        self, examiner: Examiner, unit: Worlds, start: int = 0, skip: Collection[int] = ()
    ) -> Iterator[tuple[int, Tally]]:
        """All runs of a unit, tallied in parts.

        Args:
            examiner: the explorer under the scope's rules; its heart beats with the number of
                each run.
            unit: the maps to visit.
            start: the number of the first run that has not been tallied yet.
            skip: runs that must not be tried (they have killed a worker); they are counted.

        Yields:
            After some time, and at the end, the number of the next run and the tally since.
        """
        tally = Tally(self.keep)
        due = time.monotonic() + REPORT_EVERY
        after = 0
        for run in numbered_runs(unit, self.scope.extent, self.scope.rules.kind):
            after = run.number + 1
            if run.number < start:
                continue
            if time.monotonic() > due:
                yield run.number, tally
                tally = Tally(self.keep)
                due = time.monotonic() + REPORT_EVERY
            if run.first:
                _count_world(tally, run.map)
            if run.lighthouse is None:
                tally.left_out += 1
            elif run.number in skip:
                tally.row(run.map.edge_count, run.map.vertex_count).runs += 1
            else:
                examiner.beat[0] = run.number
                world = World(run.map, run.lighthouse, 0)
                _run(examiner, self.scope, world, run.place, tally)
        yield after, tally


@dataclass(frozen=True, slots=True)
class LocalExamination:
    """An examination by one explorer in this process: an engine for any transport that stays."""

    examination: Examination
    subject: Subject

    def parts(self, unit: Worlds) -> Iterator[Tally]:
        """The tallies of the unit's parts."""
        examiner = Examiner(self.subject, self.examination.scope.rules)
        for _, tally in self.examination.parts(examiner, unit):
            yield tally


def _count_world(tally: Tally, map_: CombinatorialMap) -> None:
    tally.row(map_.edge_count, map_.vertex_count).worlds += 1
    if map_.loop_count:
        tally.witnesses["loop-edge"] += 1
    if map_.parallel_count:
        tally.witnesses["parallel-edge"] += 1


def _run(examiner: Examiner, scope: Scope, world: World, place: int, tally: Tally) -> None:
    """Every schedule of one run."""
    map_ = world.map
    name = examiner.name_run(world)
    row = tally.row(map_.edge_count, map_.vertex_count)
    row.runs += 1
    for choices in scope.schedule(name):
        outcome = examiner.examine(world, choices, name)
        cost = outcome.cost
        row.episodes += 1
        row.traversals += cost
        if place == 0:
            row.traversals_rooted += cost
        row.max_cost = max(row.max_cost, cost)
        row.bound_of(outcome.bound)
        tally.checkpoints += len(outcome.episode.checkpoints)
        if outcome.violation and tally.wants(map_.edge_count, map_.vertex_count):
            tally.find(make_finding(examiner, world, place, outcome))
    tally.witnesses.update(examiner.events)
    examiner.events.clear()
