"""Plays of earlier runs that are played again among later ones."""

from __future__ import annotations

import secrets
from random import Random
from typing import Generic, TypeVar

from msgspec import Struct, field

FEW = 16
"""The least number of runs among which the order is drawn."""

BEGINNING = 128
"""The number of second plays that is the beginning of a check, in which even a unit of one run is
played often enough."""

SPARE = 20
"""The largest number of plays besides those that are due."""

FIRST, KEPT = 64, 256
"""The number of plays that are kept for good, and in all, to be played again among later ones."""

P = TypeVar("P")


class EarlierPlays(Struct, Generic[P]):
    """Plays that were equal twice, which are played again among those of other units and levels.

    Otherwise an explorer that counts the second plays would know which level they come from.

    Attributes:
        random: draws the plays.
        spare: the number of plays that may be made besides those that are due.
    """

    random: Random = field(default_factory=lambda: Random(secrets.randbits(64)))  # noqa: S311
    spare: int = SPARE
    _plays: list[P] = field(default_factory=list)
    _drawn: int = 0

    def __len__(self) -> int:
        return len(self._plays)

    def draw_for(self, plays: int) -> list[P]:
        """Some plays, in proportion to that number of others; at the beginning of a check more."""
        least = FEW if self._drawn < BEGINNING else FEW // 4
        drawn = self.draw(min(self.spare, max(least, plays // FEW)))
        self._drawn += len(drawn)
        return drawn

    def draw(self, most: int) -> list[P]:
        """The given number of plays, drawn, or all if there are fewer."""
        return self.random.sample(self._plays, min(most, len(self._plays)))

    def forget(self) -> None:
        """Drop all kept plays."""
        self._plays.clear()

    def keep(self, play: P) -> None:
        """Keep a play; when the memory is full, it takes the place of another one."""
        if len(self._plays) < KEPT:
            self._plays.append(play)
        else:
            self._plays[self.random.randrange(FIRST, KEPT)] = play
