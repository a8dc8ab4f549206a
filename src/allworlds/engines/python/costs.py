"""The cost of each run, beside the tally: for comparisons and for the search for the worst."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

from allworlds.engines.python.examiner import Outcome, Referee
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.tally import Tally
from allworlds.maps import CombinatorialMap
from allworlds.world import World

MapKey: TypeAlias = tuple[int, int, tuple[int, ...], tuple[int, ...]]
"""Numbers of edges and vertices, sigma and alpha: sorts rooted maps from small to large."""


class RunCost(NamedTuple):
    """The costs of a run, over its schedules.

    Attributes:
        cheapest, most_expensive: of its episodes, in traversals.
    """

    cheapest: int
    most_expensive: int

    def joined(self, other: RunCost) -> RunCost:
        """The cheapest and the most expensive of both costs."""
        return RunCost(
            min(self.cheapest, other.cheapest), max(self.most_expensive, other.most_expensive)
        )


@dataclass(slots=True)
class CostTally(Tally):
    """A tally that knows every run.

    Attributes:
        costs: by the rooted map, and the number of the lighthouse's place in it.
        best: of runs that are not told apart: by vertices, the largest cost of the cheapest
            schedule of a run.
    """

    costs: dict[tuple[MapKey, int], RunCost] = field(default_factory=dict)
    best: dict[int, int] = field(default_factory=dict)

    def best_of(self, vertices: int, cost: int) -> None:
        """Take in the cost of a cheapest schedule."""
        self.best[vertices] = max(self.best.get(vertices, 0), cost)

    def cost(self, world: World, place: int, cost: RunCost) -> None:
        """Take in the cost of an episode."""
        key = key_of(world.map), place
        known = self.costs.get(key)
        self.costs[key] = cost if known is None else known.joined(cost)

    @property
    def best_by_vertices(self) -> dict[int, int]:
        """By vertices, the largest cost of the cheapest schedule of any run here."""
        best = dict(self.best)
        for ((_, vertices, *_), _), cost in self.costs.items():
            best[vertices] = max(best.get(vertices, 0), cost.cheapest)
        return best

    def add(self, other: Tally) -> None:
        """Take in another part's tally; no run is in two of them."""
        # Zero-argument super() does not know a class with slots.
        Tally.add(self, other)
        if isinstance(other, CostTally):
            self.costs.update(other.costs)
            for vertices, cost in other.best.items():
                self.best_of(vertices, cost)


class CostEngine(PythonEngine, frozen=True):
    """The Python engine that returns the cost of every run, too."""

    def tally(self) -> CostTally:
        """An empty tally."""
        return CostTally(self.keep)

    def count_outcome(
        self, referee: Referee, world: World, place: int, outcome: Outcome, tally: Tally
    ) -> None:
        """Add one episode of a run to the tally, and its cost."""
        super().count_outcome(referee, world, place, outcome, tally)
        assert isinstance(tally, CostTally)
        tally.cost(world, place, RunCost(outcome.cost, outcome.cost))


def key_of(map_: CombinatorialMap) -> MapKey:
    """The key of a map that is rooted at its dart 0."""
    return map_.edge_count, map_.vertex_count, tuple(map_.sigma), tuple(map_.alpha)
