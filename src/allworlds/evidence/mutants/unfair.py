"""A way that is not fair: the explorer on it folds its log rightly, and need not stop."""

from __future__ import annotations

from allworlds.explorers import OPEN, Algorithm1, FoldedLog, Walk, explore_folding, way
from allworlds.protocol import Choices, Estimate, Percept


class NearestOnly(Algorithm1):
    """Folds its log, but takes the open dart nearest to the robot, from copy to copy for ever."""

    def __init__(self, first: Percept, choices: Choices) -> None:
        super().__init__(first, choices)
        self.first = first

    def explore(self) -> Walk[Estimate]:
        """No test and no way home: only what is nearest."""
        return (yield from explore_folding(self.first, to_nearest))


def to_nearest(log: FoldedLog, here: int) -> list[int]:
    """To the open dart that is nearest to the robot."""
    return way(log, here, lambda dart: log.beyond(dart) == OPEN)
