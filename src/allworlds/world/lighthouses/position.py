"""Position without direction: one undirected immovable marker."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import ClassVar

from typing_extensions import override

from allworlds.maps import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import ReferenceLighthouse, StandsAt
from allworlds.world.lighthouses.place_checks import check_at_start
from allworlds.world.lighthouses.sensing import Sensing, Where


@dataclass(frozen=True, slots=True)
class Position(ReferenceLighthouse):
    """One marker at the start vertex v0 that points nowhere.

    Sensed at v0: one mark; at every vertex the degree.  ``dart`` is any dart of v0.  It is
    not compared: in worlds with one start, two of these stand at one vertex.
    Source: Section III of the paper ('unique position information').
    """

    dart: StandsAt = field(compare=False)

    kind: ClassVar[str] = "position"
    sensing: ClassVar[Sensing] = Sensing(Where.AT_V0, bearing=False)
    leaves_open: ClassVar[bool] = True

    @classmethod
    def places(
        cls,
        map_: CombinatorialMap,  # noqa: ARG003  # there is one place in every map
        start: Dart,
    ) -> Iterator[Position]:
        """Yield the one place: the start's vertex."""
        yield cls(start)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the marked vertex is the start's."""
        check_at_start("stands at", self.dart, map_, start)

    @override
    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        return (self.dart,)
