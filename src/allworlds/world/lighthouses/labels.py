"""A baseline: every vertex has a number of its own and a direction."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, ClassVar

from typing_extensions import override

from allworlds.document import Aside, Some, about
from allworlds.inputs import show
from allworlds.maps import CombinatorialMap, Dart, numbering
from allworlds.protocol import Percept
from allworlds.world.lighthouses.base import ReferenceLighthouse, WalkInAnswer
from allworlds.world.lighthouses.place_checks import (
    InvalidWorld,
    check_one_of_each_vertex,
    the_darts,
)
from allworlds.world.lighthouses.sensing import Sensing, Where


@dataclass(frozen=True, slots=True)
class Labels(ReferenceLighthouse):
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
    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        return self.darts

    @override
    def percepts(self, map_: CombinatorialMap) -> tuple[Percept, ...]:
        return self.sensing.percepts(map_, self.darts, self.numbers)

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Labels:  # noqa: ARG002  # sensed
        """The labels sensed at the first visit of each vertex; 0 for vertices never visited."""
        answer = walk.map
        at = {vertex: (darts[0], 0) for vertex, darts in enumerate(answer.vertices)}
        for dart, percept in reversed([*zip(walk.trail, walk.sensed, strict=True)]):
            assert percept.bearing is not None
            at[answer.vertex_of[dart]] = (answer.turn(dart, percept.bearing), percept.marks)
        return Labels(tuple(dart for dart, _ in at.values()), tuple(n for _, n in at.values()))

    @classmethod
    def at(cls, darts: object) -> Labels:  # type: ignore[override]  # its only field
        """The labels with these reference darts, in the order of their numbers."""
        return cls.of(the_darts(darts))
