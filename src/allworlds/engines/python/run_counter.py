"""The runs of a unit, and their counting in all engines."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from msgspec import Struct

from allworlds.engines.python.examiner import Outcome, Referee
from allworlds.engines.python.runs_of_unit import NumberedRun, UnitOfRuns, numbered_runs
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.tally import AtRun, Tally
from allworlds.maps import rooted_code
from allworlds.world import World

REPORT_EVERY = 0.25
"""Seconds after which a part of a unit is handed over."""


class EnginesDisagree(Exception):
    """Raised if two engines differ about one world."""


class RunCounter(Struct, frozen=True):
    """The runs of units, and their counting.

    Attributes:
        scope: the worlds and the rules of the check.
        keep: the number of findings that are kept.
        compiled_from: the number of worlds of a level from which on compiled code judges the runs
            of a user's explorer; None: never.
    """

    scope: Scope
    keep: int
    compiled_from: int | None = None

    def runs(self, unit: UnitOfRuns, start: int = 0) -> Iterator[NumberedRun]:
        """The runs of a unit from that number on."""
        every = numbered_runs(unit, self.scope.extent, self.scope.rules.kind)
        return islice(every, start, None)

    def tally(self) -> Tally:
        """An empty tally."""
        return Tally(self.keep)

    def count_run(self, run: NumberedRun, tally: Tally) -> World | None:
        """Count a run, and return its world; None if that has no place for the lighthouse."""
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

    def count_outcome(self, world: World, place: int, outcome: Outcome, tally: Tally) -> None:
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

    def settle(
        self, referee: Referee, world: World, place: int, outcome: Outcome, tally: Tally
    ) -> None:
        """Find a run that may break a law, once it is known what both plays of it mean."""
        if outcome.violation and tally.wants(world.map.edge_count, world.map.vertex_count):
            tally.find(referee.finding(world, place, outcome))

    def count_best(self, world: World, cost: int, tally: Tally) -> None:
        """Add the cost of a run's cheapest schedule to the tally, if every schedule is tried."""
        if self.scope.schedules == "all":
            tally.row(world.map.edge_count, world.map.vertex_count).best_of(cost)
