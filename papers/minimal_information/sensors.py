"""Sensors that tell more than the door, less, or something else; for ``allworlds ambiguity``.

Each stands at a marked dart of v0, its *door*; the start is any dart of v0.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from typing_extensions import override

from allworlds import CombinatorialMap, Lighthouse, Percept


@dataclass(frozen=True)
class AtDoor(Lighthouse):
    """The base: a marked dart of v0. A class below says what is sensed, as a letter."""

    dart: int
    gives_bearings = False

    @classmethod
    @override
    def places(cls, map_: CombinatorialMap, start: int) -> Iterator[Lighthouse]:
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def letter(self, map_: CombinatorialMap, here: int) -> int:
        """The number that is sensed by who has come by the dart ``here``."""
        raise NotImplementedError

    @override
    def sensed(self, map_: CombinatorialMap, here: int) -> Percept:
        return Percept(map_.degree_at[here], int(self.letter(map_, here)))


@dataclass(frozen=True)
class Features(AtDoor):
    """Six kinds of darts, by their place relative to the door."""

    features = ("away", "neighbour", "behind", "door", "next", "other")

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        owner = map_.vertex_of
        v0 = owner[self.dart]
        if here == self.dart:
            return 3
        if here == map_.alpha[self.dart]:
            return 2
        if owner[here] == v0:
            return 4 if here == map_.sigma[self.dart] else 5
        return v0 in {owner[map_.alpha[dart]] for dart in map_.vertices[owner[here]]}
