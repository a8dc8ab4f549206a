"""The percepts of each kind of lighthouse: the one definition, for worlds and for formulas."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cache

from allworlds.maps import CombinatorialMap, Dart
from allworlds.protocol import Percept


class Where(Enum):
    """The vertices at which more than the degree is sensed."""

    NOWHERE = "nowhere"
    AT_V0 = "at the start's vertex"
    AT_V0_AND_V1 = "at the start's vertex and at a neighbour of it"
    EVERYWHERE = "everywhere"
    EVERYWHERE_NUMBERED = "everywhere, and each vertex has a number of its own"


@dataclass(frozen=True, slots=True)
class Sensing:
    """The part of a robot's percepts that a lighthouse causes; the degree comes on top.

    Attributes:
        where: the vertices at which there is such a part.
        bearing: whether the bearing of one of the vertex's darts, its reference dart, is sensed.
    """

    where: Where
    bearing: bool

    @property
    def marks_v0(self) -> bool:
        """Whether one mark lies at v0, so that v0 is recognised by its percept alone."""
        return self.where in (Where.AT_V0, Where.AT_V0_AND_V1)

    @property
    def marks(self) -> bool:
        """Whether there are marks at all."""
        return self.marks_v0 or self.where is Where.EVERYWHERE_NUMBERED

    def percepts(
        self,
        map_: CombinatorialMap,
        references: Sequence[Dart],
        numbers: Sequence[int] | None = None,
    ) -> tuple[Percept, ...]:
        """For each dart the percept of a robot that has arrived by it.

        ``references`` holds one dart of each vertex at which more than the degree is sensed.
        Where there are marks, ``numbers`` says how many lie at each of these vertices; by
        default one at the first, two at the second.
        """
        if numbers is None:
            numbers = range(1, len(references) + 1)
        sensed = [_percept(degree) for degree in map_.degree_at]
        # The first comes last: where a wrong answer takes v1 for v0, what is sensed is v0.
        for number, reference in reversed([*zip(numbers, references, strict=True)]):
            marks = number if self.marks else 0
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
