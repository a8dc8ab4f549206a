"""What each level of information senses: the one definition, for worlds and for formulas."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cache

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol import Percept


class Where(Enum):
    """The vertices at which more than the degree is sensed."""

    NOWHERE = "nowhere"
    AT_V0 = "at the start's vertex"
    EVERYWHERE = "everywhere"


@dataclass(frozen=True, slots=True)
class Sensing:
    """A level of information: what a robot senses besides the degree.

    Attributes:
        where: at which vertices anything is.
        bearing: whether it is the bearing of one of the vertex's darts, its reference dart.
    """

    where: Where
    bearing: bool

    @property
    def marks_v0(self) -> bool:
        """One mark lies at v0: what is sensed at one vertex alone tells it from all others."""
        return self.where is Where.AT_V0

    def percepts(self, map_: CombinatorialMap, references: Sequence[Dart]) -> tuple[Percept, ...]:
        """For each dart what is sensed by a robot that has arrived by it.

        ``references`` holds one dart of each vertex at which more than the degree is sensed.
        """
        sensed = [_percept(degree) for degree in map_.degree_at]
        marks = int(self.marks_v0)
        for reference in references:
            degree = map_.degree_at[reference]
            for back in range(degree):
                # sigma^back(d) is the reference dart for the dart d that lies back places before.
                bearing = back if self.bearing else None
                sensed[map_.turn(reference, -back)] = _percept(degree, marks, bearing)
        return tuple(sensed)


@cache
def _percept(degree: int, marks: int = 0, bearing: int | None = None) -> Percept:
    """A percept; equal ones are one object."""
    return Percept(degree, marks, bearing)
