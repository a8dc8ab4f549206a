"""The sense in which an explorer lists the darts round a vertex, seen in another world."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True, slots=True)
class Chirality:
    """The result of playing the explorer of a finding in a chiral world.

    Attributes:
        rotations: the order in which the explorer lists the darts round a vertex.
        where: the chiral world in words, or, if the order is unknown, the reason as a clause.
    """

    rotations: Literal["clockwise", "anticlockwise", "unknown"]
    where: str
