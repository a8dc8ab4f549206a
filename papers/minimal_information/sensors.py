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


@dataclass(frozen=True)
class Rooms(AtDoor):
    """Three kinds of vertices: nothing tells one door from another."""

    features = ("away", "neighbour", "here")

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        return (0, 2, 1)[Glow(self.dart).letter(map_, here)]


@dataclass(frozen=True)
class Bit(AtDoor):
    """One bit: whether one has come by a dart of these kinds, as in ``Bit:of=neighbour-other``."""

    of: str = "door"

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        kind = Features.features[Features(self.dart).letter(map_, here)]
        return kind in self.of.split("-")


@dataclass(frozen=True)
class Half(AtDoor):
    """At v0, whether the door is to the left or to the right: 1 for a bearing below half."""

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        if map_.vertex_of[here] != map_.vertex_of[self.dart]:
            return 0
        return 1 if 2 * map_.offset(here, self.dart) < map_.degree_at[here] else 2


@dataclass(frozen=True)
class Distance(AtDoor):
    """At v0, how far the door is, on whichever side, from 1 on."""

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        if map_.vertex_of[here] != map_.vertex_of[self.dart]:
            return 0
        bearing = map_.offset(here, self.dart)
        return 1 + min(bearing, map_.degree_at[here] - bearing)


@dataclass(frozen=True)
class BothEnds(AtDoor):
    """Both ends of the door's edge: the door is 1, the dart behind it ``behind``."""

    behind: int = 2

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        return 1 if here == self.dart else self.behind if here == map_.alpha[self.dart] else 0


@dataclass(frozen=True)
class Face(AtDoor):
    """Every dart of the door's face."""

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        return any({here, self.dart} <= {*face} for face in map_.faces)


@dataclass(frozen=True)
class Glow(AtDoor):
    """At v0 1, at a neighbour of v0 2."""

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        owner = map_.vertex_of
        v0 = owner[self.dart]
        near = {owner[map_.alpha[dart]] for dart in map_.vertices[v0]}
        return 1 if owner[here] == v0 else 2 if owner[here] in near else 0


@dataclass(frozen=True)
class CameFrom(AtDoor):
    """Whether one is at v0, and whether one was there before the last motion."""

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        owner = map_.vertex_of
        v0 = owner[self.dart]
        return (owner[here] == v0) + 2 * (owner[map_.alpha[here]] == v0)


@dataclass(frozen=True)
class TwoMarkers(AtDoor):
    """At v0 a mark, and at the vertex behind the door as many as ``second``."""

    second: int = 1

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        owner = map_.vertex_of
        beyond = owner[map_.alpha[self.dart]]
        return 1 if owner[here] == owner[self.dart] else self.second * (owner[here] == beyond)


@dataclass(frozen=True)
class AtDegree(AtDoor):
    """A cyclic word at the marked vertex, which has as many doors as the word has letters."""

    word: str = "1"

    @classmethod
    @override
    def places(cls, map_: CombinatorialMap, start: int) -> Iterator[Lighthouse]:
        if map_.degree_at[start] == len(cls.word):
            yield from super().places(map_, start)

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        if map_.vertex_of[here] != map_.vertex_of[self.dart]:
            return 0
        return int(self.word[map_.offset(here, self.dart)])


@dataclass(frozen=True)
class DoorBut(AtDoor):
    """The door, but not where its vertex has this many doors."""

    degree: int = 1

    @override
    def letter(self, map_: CombinatorialMap, here: int) -> int:
        return here == self.dart and map_.degree_at[here] != self.degree
