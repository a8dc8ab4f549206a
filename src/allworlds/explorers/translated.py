"""An explorer with one wrong convention, and a translator between it and the world.

``CONVENTIONS`` is **the** table.  If an explorer that breaks a law breaks none behind a translator,
then it counts as that convention says, and all else in it is right.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Generator
from contextlib import closing
from typing import Any

from msgspec import Struct

from allworlds.protocol.actions import Move, Percept


def _as_it_is(number: int) -> int:
    return number


class Convention(Struct, frozen=True):
    """A wrong way to count darts.

    Attributes:
        wrong: what the explorer does, after 'the explorer'.
        right: the rule that it misses.
        motion: the motion that is meant by the one that the explorer makes.
        bearing: the bearing that the explorer must be told, for the one that is sensed.
    """

    wrong: str
    right: str
    motion: Callable[[int], int] = _as_it_is
    bearing: Callable[[int], int] = _as_it_is


_MOTIONS = "Motion k leaves by the k-th dart clockwise from the dart by which the robot came"

CONVENTIONS = {
    "motions-anticlockwise": Convention(
        "counts motions anticlockwise (or else sigma and bearings)",
        f"{_MOTIONS}.",
        motion=lambda k: -k,
    ),
    "motions-from-1": Convention(
        "counts motions from 1", f"{_MOTIONS}, and that dart is number 0.", motion=lambda k: k - 1
    ),
    "motions-from-next": Convention(
        "counts motions from the next dart, as if that were number 0",
        f"{_MOTIONS}, and that dart is number 0.",
        motion=lambda k: k + 1,
    ),
    "bearings-anticlockwise": Convention(
        "counts bearings anticlockwise (or else sigma and motions)",
        "A bearing counts the darts clockwise, from the dart by which the robot arrives to the "
        "pointed dart.",
        bearing=lambda b: -b,
    ),
}
"""The conventions by their names; the likelier ones first."""


class Translated:
    """An explorer behind a translator: a generator function that takes what the explorer takes."""

    def __init__(
        self, explorer: Callable[..., Generator[Any, Any, Any]], convention: Convention
    ) -> None:
        self.explorer, self.convention = explorer, convention
        self.__signature__ = inspect.signature(explorer)

    def __call__(self, first: Percept, **keywords: Any) -> Generator[Any, Any, Any]:
        """Explore as the explorer does that is meant."""
        with closing(self.explorer(self._heard(first), **keywords)) as walk:
            heard = None
            while True:
                try:
                    message = walk.send(heard)
                except StopIteration as end:
                    return end.value
                if type(message) is Move and type(message.k) is int:
                    message = Move(self.convention.motion(message.k))
                reply = yield message
                heard = None if reply is None else self._heard(reply)

    def _heard(self, percept: Percept) -> Percept:
        if percept.bearing is None:
            return percept
        bearing = self.convention.bearing(percept.bearing) % percept.degree
        return Percept(percept.degree, percept.marks, bearing)
