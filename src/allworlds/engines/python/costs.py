"""The cost of each run, beside the tally: for comparisons."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

from allworlds.engines.python.examiner import Outcome
from allworlds.engines.python.run_counter import RunCounter
from allworlds.engines.python.tally import Tally
from allworlds.maps import CombinatorialMap
from allworlds.world import World

MapKey: TypeAlias = tuple[int, int, tuple[int, ...], tuple[int, ...]]
"""Numbers of edges and vertices, sigma and alpha: sorts rooted maps from small to large."""


@dataclass(slots=True)
class CostTally(Tally):
    """A tally that knows every run.

    Attributes:
        costs: by the rooted map, and the number of the lighthouse's place in it.
    """

    costs: dict[tuple[MapKey, int], int] = field(default_factory=dict)

    def add(self, other: Tally) -> None:
        """Take in another part's tally; no run is in two of them."""
        # Zero-argument super() does not know a class with slots.
        Tally.add(self, other)
        if isinstance(other, CostTally):
            self.costs.update(other.costs)


class CostEngine(RunCounter, frozen=True):
    """The counter that returns the cost of every run, too."""

    def tally(self) -> CostTally:
        """An empty tally."""
        return CostTally(self.keep)

    def count_outcome(self, world: World, place: int, outcome: Outcome, tally: Tally) -> None:
        """Add a run, which has one episode, to the tally, and its cost."""
        super().count_outcome(world, place, outcome, tally)
        assert isinstance(tally, CostTally)
        tally.costs[key_of(world.map), place] = outcome.cost


def key_of(map_: CombinatorialMap) -> MapKey:
    """The key of a map that is rooted at its dart 0."""
    return map_.edge_count, map_.vertex_count, tuple(map_.sigma), tuple(map_.alpha)
