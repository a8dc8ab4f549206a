"""Position at two neighbours: the marker cluster."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

from allworlds.document import about
from allworlds.inputs import show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import (
    InvalidWorld,
    ReferenceLighthouse,
    StandsAt,
    WalkInAnswer,
    check_leads_away,
    no_place,
)
from allworlds.world.lighthouses.sensing import Sensing, Where


@dataclass(frozen=True, slots=True)
class Cluster(ReferenceLighthouse):
    """One marker at the start vertex v0 and two at a neighbour v1 of it; they point nowhere.

    Sensed: one mark at v0, two at v1; at every vertex the degree.  ``dart`` leads from v0 to
    v1.  With the option ``single=true`` it stands only where exactly one edge joins the two.
    Source: Sections IV and VIII of the paper.
    """

    dart: StandsAt

    kind: ClassVar[str] = "cluster"
    sensing: ClassVar[Sensing] = Sensing(Where.AT_V0_AND_V1, bearing=False)
    keys: ClassVar[tuple[str, ...]] = ("dart", "single")
    asked: ClassVar[Mapping[str, Any]] = {
        "single": Annotated[bool, about("whether exactly one edge joins v0 and v1; else false")]
    }

    @classmethod
    def with_options(cls, options: Mapping[str, str]) -> type[Cluster]:
        """The kind with ``single=true`` or ``single=false``."""
        for key, value in options.items():
            if key != "single":
                raise InvalidWorld(
                    f"the cluster lighthouse has no option {show(key)}; legal is single"
                )
            if value not in ("true", "false"):
                raise InvalidWorld(
                    f"option single = {show(value)} of the cluster lighthouse is neither true "
                    "nor false"
                )
        return SingleCluster if options.get("single") == "true" else Cluster

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Cluster]:
        """One place for each dart of v0 that leads to another vertex, clockwise."""
        v0 = map_.vertex_of[start]
        for bearing in range(map_.degree_at[start]):
            dart = map_.turn(start, bearing)
            if map_.vertex_of[map_.alpha[dart]] != v0:
                yield Cluster(dart)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the dart leads from the start's vertex to another one."""
        check_leads_away(self.dart, map_, start)

    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        """The two ends of the dart's edge."""
        return (self.dart, map_.alpha[self.dart])

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Cluster:
        """The cluster in the same direction from the start, even if it may not stand there."""
        return Cluster(walk.map.turn(walk.trail[0], map_.offset(start, self.dart)))

    @classmethod
    def from_json(cls, document: Mapping[str, Any], map_: CombinatorialMap, start: Dart) -> Cluster:
        """The cluster at ``dart``, or at the first place if no dart is named.

        With ``"single": true`` the place must be one where exactly one edge joins v0 and v1.
        """
        single = document.get("single", cls is SingleCluster)
        if type(single) is not bool:
            raise InvalidWorld(f"lighthouse.single = {show(single)} is neither true nor false")
        kind = SingleCluster if single else Cluster
        if "dart" not in document:
            for place in kind.places(map_, start):
                return place
            raise no_place("cluster:single=true" if single else "cluster", start)
        place = Cluster(document["dart"])
        place.check(map_, start)
        if place not in kind.places(map_, start):
            raise InvalidWorld(
                f"lighthouse.dart = {show(place.dart)} leads to a vertex that more than one edge "
                "joins to the start's vertex; single = true asks for exactly one"
            )
        return place


class SingleCluster(Cluster):
    """The cluster only where exactly one edge joins v0 and v1: the option ``single=true``."""

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Cluster]:
        """One place for each neighbour of v0 that one edge joins to it, clockwise."""
        places = list(Cluster.places(map_, start))
        beyond = [map_.vertex_of[map_.alpha[place.dart]] for place in places]
        edges = Counter(beyond)
        yield from (place for place, v1 in zip(places, beyond, strict=True) if edges[v1] == 1)
