"""Direction without position: a reference dart at every vertex."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, product
from typing import Annotated, ClassVar

from typing_extensions import override

from allworlds.document import Some, about
from allworlds.inputs import show
from allworlds.maps import CombinatorialMap, Dart, numbering
from allworlds.world.lighthouses.base import (
    InvalidWorld,
    Lighthouse,
    WalkInAnswer,
    check_one_of_each_vertex,
    the_darts,
)
from allworlds.world.lighthouses.sensing import Sensing, Where

ALL_CHOICES = 3
"""The largest number of edges for which every choice of reference darts is a place."""


@dataclass(frozen=True, slots=True)
class Compass(Lighthouse):
    """At every vertex a reference dart (its north), and no mark.

    Sensed: the degree, and the bearing of the vertex's reference dart.  ``darts`` holds one
    dart of each vertex, ascending.
    Source: Section III of the paper ('global orientation information but no position').
    """

    darts: Annotated[Some[Dart], about("the reference dart of each vertex, ascending")]

    kind: ClassVar[str] = "compass"
    sensing: ClassVar[Sensing] = Sensing(Where.EVERYWHERE, bearing=True)
    default_bound: ClassVar[str] = "none"
    folds: ClassVar[bool] = False
    keys: ClassVar[tuple[str, ...]] = ("darts",)

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Compass]:
        """Up to three edges every choice of reference darts; beyond, the first choice only.

        Vertices and their darts come in canonical numbering from ``start``.  So in a map that
        is numbered so itself, the first choice is the smallest dart of each vertex.
        """
        around: dict[int, list[Dart]] = {}
        for dart in numbering(map_.sigma, map_.alpha, start):
            around.setdefault(map_.vertex_of[dart], []).append(dart)
        wanted = None if map_.edge_count <= ALL_CHOICES else 1
        for choice in islice(product(*around.values()), wanted):
            yield cls(tuple(sorted(choice)))

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any start
        """The reference darts are ascending integers, one at each vertex."""
        darts = the_darts(self.darts)
        if list(darts) != sorted(darts):
            raise InvalidWorld(f"lighthouse.darts = {show(list(darts))} must be ascending")
        check_one_of_each_vertex(darts, map_)

    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:  # noqa: ARG002  # it knows
        """The dart of each vertex."""
        return self.darts

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Compass:  # noqa: ARG002  # sensed
        """The reference dart that was sensed when the robot first came to a vertex."""
        answer = walk.map
        north = {vertex: darts[0] for vertex, darts in enumerate(answer.vertices)}
        for dart, percept in reversed([*zip(walk.trail, walk.sensed, strict=True)]):
            assert percept.bearing is not None
            north[answer.vertex_of[dart]] = answer.turn(dart, percept.bearing)
        return Compass(tuple(sorted(north.values())))

    @override
    def relabelled(self, names: Sequence[Dart]) -> Compass:
        return Compass(tuple(sorted(names[dart] for dart in self.darts)))

    @classmethod
    def at(cls, where: object) -> Compass:
        """With these reference darts, in any order."""
        return cls(tuple(sorted(the_darts(where))))

    @classmethod
    def usual(cls, map_: CombinatorialMap, start: Dart) -> Compass:  # noqa: ARG003  # any start
        """With the smallest dart of each vertex."""
        return cls(tuple(vertex[0] for vertex in map_.vertices))
