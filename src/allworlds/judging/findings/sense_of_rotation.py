"""The sense in which an explorer lists the darts round a vertex, seen in another world."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct


class Chirality(Struct, frozen=True):
    """The result of playing the explorer of a finding in a chiral world.

    Attributes:
        rotations: the order in which the explorer lists the darts round a vertex.
        where: the chiral world in words, or, if the order is unknown, the reason as a clause.
    """

    rotations: Literal["clockwise", "anticlockwise", "unknown"]
    where: str
