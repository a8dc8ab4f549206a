"""No marker at all: two neighbours that have degrees of their own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from allworlds.inputs import show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import ReferenceLighthouse, StandsAt, WalkInAnswer
from allworlds.world.lighthouses.place_checks import InvalidWorld, check_leads_away
from allworlds.world.lighthouses.sensing import Sensing, Where


@dataclass(frozen=True, slots=True)
class Natural(ReferenceLighthouse):
    """The start vertex v0 and a neighbour v1 of it; no other vertex has the degree of either.

    Only the degree is sensed.  The explorer is told the degree of v1: that it is unique could
    not be sensed.  ``dart`` is any dart that leads from v0 to v1.
    Source: Section VIII of the paper.
    """

    dart: StandsAt

    kind: ClassVar[str] = "natural"
    sensing: ClassVar[Sensing] = Sensing(Where.NOWHERE, bearing=False)

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Natural]:
        """One place for each neighbour that will do, at the first dart clockwise to it."""
        vertices = Counter(map_.degrees)
        if vertices[map_.degree_at[start]] > 1:
            return
        met = {map_.degree_at[start]}
        for bearing in range(map_.degree_at[start]):
            dart = map_.turn(start, bearing)
            degree = map_.degree_at[map_.alpha[dart]]
            if degree not in met and vertices[degree] == 1:
                met.add(degree)
                yield cls(dart)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the dart leads to another vertex, both of unique degree."""
        check_leads_away(self.dart, map_, start)
        vertices = Counter(map_.degrees)
        for name, dart in (("start's vertex", start), ("other vertex", map_.alpha[self.dart])):
            degree = map_.degree_at[dart]
            if vertices[degree] > 1:
                raise InvalidWorld(
                    f"lighthouse.dart = {show(self.dart)}: the {name} has degree {degree}, and so "
                    f"have {vertices[degree]} vertices; a natural lighthouse needs unique degrees"
                )

    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:  # noqa: ARG002  # any map
        """The empty tuple: only the degree is sensed anywhere."""
        return ()

    def told(self, map_: CombinatorialMap) -> int:
        """The degree of v1."""
        return map_.degree_at[map_.alpha[self.dart]]

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Natural:
        """The lighthouse in the same direction from the start, even if it may not stand there."""
        return Natural(walk.map.turn(walk.trail[0], map_.offset(start, self.dart)))
