"""Lighthouses at one or two marked vertices."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Annotated, ClassVar, Self

from typing_extensions import override

from allworlds.document.struct import IfAny, about
from allworlds.inputs.checks import show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import (
    ReferenceLighthouse,
    Sensing,
    StandsAt,
    WalkInAnswer,
    Where,
)
from allworlds.world.lighthouses.options import (
    InvalidWorld,
    check_at_start,
    check_leads_away,
    ensure_legal,
)


class AtOneDart(ReferenceLighthouse):
    """A lighthouse of which all that is sensed follows from its dart."""

    dart: Dart

    @override
    def references(self, map_: CombinatorialMap) -> tuple[Dart, ...]:
        return (self.dart,)


class TowardsNeighbour(ReferenceLighthouse):
    """A lighthouse at v0 and at the vertex v1 to which its dart leads."""

    dart: Dart

    def believed(self, map_: CombinatorialMap, start: Dart, walk: WalkInAnswer) -> Self:
        """The lighthouse in the same direction from the start, even if it may not stand there."""
        dart = walk.map.turn(walk.trail[0], map_.offset(start, self.dart))
        return replace(self, dart=dart)  # type: ignore[type-var]


@dataclass(frozen=True, slots=True)
class Position(AtOneDart):
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
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Position]:  # noqa: ARG003
        """Yield the one place: the start's vertex."""
        yield cls(start)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the marked vertex is the start's."""
        check_at_start("stands at", self.dart, map_, start)


@dataclass(frozen=True, slots=True)
class Directional(AtOneDart):
    """One marker at the start vertex v0 that points to one of its darts.

    Sensed at v0: one mark, and the bearing of ``dart``; elsewhere only the degree.
    Source: Section IV of the paper.
    """

    dart: StandsAt

    kind: ClassVar[str] = "directional"
    sensing: ClassVar[Sensing] = Sensing(Where.AT_V0, bearing=True)
    default_bound: ClassVar[str] = "paper"
    folds: ClassVar[bool] = True

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Directional]:
        """One place for each bearing ``0..deg(v0)-1``."""
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the pointed dart is one of the start's vertex."""
        check_at_start("points to", self.dart, map_, start)


@dataclass(frozen=True)
class Cluster(TowardsNeighbour):
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


@dataclass(frozen=True, slots=True)
class Natural(TowardsNeighbour):
    """The start vertex v0 and a neighbour v1 of it; no other vertex has the degree of either.

    Only the degree is sensed.  The explorer is told the degree of v1: that it is unique could
    not be sensed.  ``dart`` is any dart that leads from v0 to v1.
    Source: Section VIII of the paper.
    """

    dart: StandsAt

    kind: ClassVar[str] = "natural"

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

    def told(self, map_: CombinatorialMap) -> int:
        """The degree of v1."""
        return map_.degree_at[map_.alpha[self.dart]]
