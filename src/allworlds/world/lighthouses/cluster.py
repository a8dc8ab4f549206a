"""Position at two neighbours: the marker cluster."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Annotated, ClassVar

from allworlds.document import IfAny, about
from allworlds.inputs import show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import ReferenceLighthouse, StandsAt, WalkInAnswer
from allworlds.world.lighthouses.options import ensure_legal
from allworlds.world.lighthouses.place_checks import InvalidWorld, check_leads_away
from allworlds.world.lighthouses.sensing import Sensing, Where


@dataclass(frozen=True)
class Cluster(ReferenceLighthouse):
    """One marker at the start vertex v0 and two at a neighbour v1 of it; they point nowhere.

    Sensed: one mark at v0, two at v1; at every vertex the degree.  ``dart`` leads from v0 to
    v1.  With the option ``single=true`` it stands only where exactly one edge joins the two.
    Source: Sections IV and VIII of the paper.
    """

    dart: StandsAt
    single: Annotated[
        IfAny[bool], about("whether exactly one edge joins v0 and v1; else false")
    ] = False

    kind: ClassVar[str] = "cluster"
    sensing: ClassVar[Sensing] = Sensing(Where.AT_V0_AND_V1, bearing=False)

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Cluster]:
        """One place for each dart of v0 that leads to another vertex, clockwise."""
        v0 = map_.vertex_of[start]
        around = [map_.turn(start, bearing) for bearing in range(map_.degree_at[start])]
        beyond = {dart: map_.vertex_of[map_.alpha[dart]] for dart in around}
        edges = Counter(beyond.values())
        for dart, v1 in beyond.items():
            if v1 != v0 and (edges[v1] == 1 or not cls.single):
                yield cls(dart)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the dart leads from the start's vertex to another one.

        With ``single`` no other edge may lead there.
        """
        ensure_legal(self)
        check_leads_away(self.dart, map_, start)
        if self.single and self not in self.as_kind.places(map_, start):
            raise InvalidWorld(
                f"lighthouse.dart = {show(self.dart)} leads to a vertex that more than one edge "
                "joins to the start's vertex; single = true asks for exactly one"
            )

    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        """The two ends of the dart's edge."""
        return (self.dart, map_.alpha[self.dart])

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Cluster:
        """The cluster in the same direction from the start, even if it may not stand there."""
        return replace(self, dart=walk.map.turn(walk.trail[0], map_.offset(start, self.dart)))
