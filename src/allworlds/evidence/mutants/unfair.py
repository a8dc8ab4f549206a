"""An unfair way to walk: its explorer folds the log rightly, but need not stop."""

from __future__ import annotations

from allworlds.explorers import OPEN, Algorithm1, FoldedLog, Walk, explore_folding, way
from allworlds.protocol import Choices, Estimate, Percept


class NearestOnly(Algorithm1):
    """An explorer that always takes the nearest open dart, from copy to copy for ever."""

    def __init__(self, first: Percept, choices: Choices) -> None:
        super().__init__(first, choices)
        self.first = first

    def explore(self) -> Walk[Estimate]:
        """Walk without tests, to the nearest open dart each time."""
        return (yield from explore_folding(self.first, to_nearest))


def to_nearest(log: FoldedLog, here: int) -> list[int]:
    """The way to the open dart that is nearest to the robot."""
    return way(log, here, lambda dart: log.beyond(dart) == OPEN)
