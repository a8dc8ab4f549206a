"""Lighthouses that mark every vertex."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, product
from typing import Annotated, ClassVar

from typing_extensions import override

from allworlds.document.struct import Aside, Some, about
from allworlds.inputs.checks import show
from allworlds.maps.canonical import numbering
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Percept
from allworlds.world.lighthouses.base import ReferenceLighthouse, Sensing, WalkInAnswer, Where
from allworlds.world.lighthouses.options import (
    InvalidWorld,
    check_one_of_each_vertex,
    the_darts,
)


class AtEveryVertex(ReferenceLighthouse):
    """A lighthouse with a reference dart at every vertex."""

    darts: tuple[Dart, ...]

    @override
    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        return self.darts


def _met(walk: WalkInAnswer) -> dict[int, tuple[Dart, int]]:
    """The reference dart and the marks sensed at the first visit of each vertex of an answer.

    Of one that was never visited, they are its first dart, and 0.
    """
    answer = walk.map
    found = {vertex: (darts[0], 0) for vertex, darts in enumerate(answer.vertices)}
    for dart, percept in reversed([*zip(walk.trail, walk.sensed, strict=True)]):
        assert percept.bearing is not None
        found[answer.vertex_of[dart]] = (answer.turn(dart, percept.bearing), percept.marks)
    return found


@dataclass(frozen=True, slots=True)
class Compass(AtEveryVertex):
    """At every vertex a reference dart (its north), and no mark.

    Sensed: the degree, and the bearing of the vertex's reference dart.  ``darts`` holds one
    dart of each vertex, ascending.
    Source: Section III of the paper ('global orientation information but no position').
    """

    darts: Annotated[Some[Dart], about("the reference dart of each vertex, ascending")]

    kind: ClassVar[str] = "compass"
    sensing: ClassVar[Sensing] = Sensing(Where.EVERYWHERE, bearing=True)
    every_place_to: ClassVar[int | None] = 3
    beyond: ClassVar[str] = "the compass at the smallest dart of each vertex alone"

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Compass]:
        """Every choice of reference darts up to three edges; beyond, the first choice alone.

        Vertices and their darts come in canonical numbering from ``start``.  So in a map that
        is numbered so itself, the first choice is the smallest dart of each vertex.
        """
        around: dict[int, list[Dart]] = {}
        for dart in numbering(map_.sigma, map_.alpha, start):
            around.setdefault(map_.vertex_of[dart], []).append(dart)
        assert cls.every_place_to is not None
        wanted = None if map_.edge_count <= cls.every_place_to else 1
        for choice in islice(product(*around.values()), wanted):
            yield cls(tuple(sorted(choice)))

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any start
        """Raise InvalidWorld unless the reference darts are ascending, one at each vertex."""
        darts = the_darts(self.darts)
        if list(darts) != sorted(darts):
            raise InvalidWorld(f"lighthouse.darts = {show(list(darts))} must be ascending")
        check_one_of_each_vertex(darts, map_)

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Compass:  # noqa: ARG002  # sensed
        """The compass with the reference darts sensed at the first visit of each vertex."""
        return Compass(tuple(sorted(dart for dart, _ in _met(walk).values())))

    @override
    def relabelled(self, names: Sequence[Dart]) -> Compass:
        return Compass(tuple(sorted(names[dart] for dart in self.darts)))

    @classmethod
    def at(cls, darts: object) -> Compass:  # type: ignore[override]  # its only field
        """The compass with these reference darts, in any order."""
        return cls(tuple(sorted(the_darts(darts))))

    @classmethod
    def usual(cls, map_: CombinatorialMap, start: Dart) -> Compass:  # noqa: ARG003  # any start
        """The compass with the smallest dart of each vertex."""
        return cls(tuple(vertex[0] for vertex in map_.vertices))


@dataclass(frozen=True, slots=True)
class Labels(AtEveryVertex):
    """Every vertex has a number of its own, and a reference dart.

    Sensed at a vertex: as many marks as its number, the bearing of its reference dart, and
    the degree.  So all vertices are told apart: other lighthouses are compared with this one.

    Attributes:
        darts: the reference dart of each vertex, in the order of their numbers.
        numbers: the numbers of the vertices; 1, 2, 3 ... in every world.
    """

    darts: Annotated[
        Some[Dart], about("the reference dart of each vertex, in the order of their numbers")
    ]
    numbers: Aside[tuple[int, ...]]

    kind: ClassVar[str] = "labels"
    sensing: ClassVar[Sensing] = Sensing(Where.EVERYWHERE_NUMBERED, bearing=True)

    @classmethod
    def of(cls, darts: tuple[Dart, ...]) -> Labels:
        """The labels with these reference darts, numbered in their order from 1 on."""
        return cls(darts, tuple(range(1, len(darts) + 1)))

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Labels]:
        """One place: vertices and their first darts in canonical numbering from ``start``."""
        first: dict[int, Dart] = {}
        for dart in numbering(map_.sigma, map_.alpha, start):
            first.setdefault(map_.vertex_of[dart], dart)
        yield cls.of(tuple(first.values()))

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any start
        """Raise InvalidWorld unless the reference darts are integers, one at each vertex."""
        darts = the_darts(self.darts)
        check_one_of_each_vertex(darts, map_)
        if list(self.numbers) != list(range(1, len(darts) + 1)):
            raise InvalidWorld(
                f"the labels {show(list(self.numbers))} are not 1 to {len(darts)}, one a vertex"
            )

    @override
    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        return self.sensing.percepts(map_, self.darts, self.numbers)

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Labels:  # noqa: ARG002  # sensed
        """The labels sensed at the first visit of each vertex; 0 for vertices never visited."""
        darts, numbers = zip(*_met(walk).values(), strict=True)
        return Labels(darts, numbers)

    @classmethod
    def at(cls, darts: object) -> Labels:  # type: ignore[override]  # its only field
        """The labels with these reference darts, in the order of their numbers."""
        return cls.of(the_darts(darts))
