"""Lighthouses that stand at vertices: at the start's, at a neighbour of it too, or at every one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import count, islice, product
from typing import Annotated, Any, ClassVar, Self

from typing_extensions import override

from allworlds.document import IfAny, NotInDocument, Some, about
from allworlds.inputs.checks import are_plain, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart, numbering
from allworlds.world.lighthouses import base
from allworlds.world.lighthouses.options import InvalidWorld, ensure_legal, the_integer

# ---------------------------------------------------------------- at one or two vertices


class MarkedStart(base.ReferenceLighthouse):
    """A lighthouse at the start's vertex v0, of which all that is sensed follows from its dart."""

    dart: Dart

    @override
    def references(self, map_: CombinatorialMap) -> Mapping[Dart, int]:
        return {self.dart: 1} if self.sensing.marks else {}

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless its dart is one of the start's vertex."""
        dart = the_integer("lighthouse.dart", self.dart)
        at_start = map_.vertices[map_.vertex_of[start]]
        if dart not in at_start:
            raise InvalidWorld(
                f"the lighthouse stands at dart {show(dart)}, which is not at the start's vertex; "
                f"legal are {', '.join(map(str, at_start))}"
            )


class TowardsNeighbour(MarkedStart):
    """A lighthouse at v0 and at the vertex v1 to which its dart leads."""

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless its dart leads from the start's vertex to another vertex."""
        super().check(map_, start)
        at_start = map_.vertices[map_.vertex_of[start]]
        if map_.alpha[self.dart] in at_start:
            legal = [d for d in at_start if map_.alpha[d] not in at_start]
            raise InvalidWorld(
                f"lighthouse.dart = {show(self.dart)} leads back to the start's vertex, not to "
                f"another one; legal are {', '.join(map(str, legal)) or 'none'}"
            )

    def believed(self, map_: CombinatorialMap, start: Dart, walk: base.WalkInAnswer) -> Self:
        """The lighthouse in the same direction from the start, even if it may not stand there."""
        dart = walk.map.turn(walk.trail[0], map_.offset(start, self.dart))
        return replace(self, dart=dart)  # type: ignore[type-var]


@dataclass(frozen=True, slots=True)
class Position(MarkedStart):
    """One marker at the start vertex v0 that points nowhere.

    Sensed at v0: one mark; at every vertex the degree.  ``dart`` is any dart of v0.  It is
    not compared: in worlds with one start, two of these stand at one vertex.
    Source: Section III of the paper ('unique position information').
    """

    dart: base.StandsAt = field(compare=False)

    kind: ClassVar[str] = "position"
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.AT_V0, bearing=False)
    leaves_open: ClassVar[bool] = True

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Position]:  # noqa: ARG003
        """Yield the one place: the start's vertex."""
        yield cls(start)


@dataclass(frozen=True, slots=True)
class Directional(MarkedStart):
    """One marker at the start vertex v0 that points to one of its darts.

    Sensed at v0: one mark, and the bearing of ``dart``; elsewhere only the degree.
    Source: Section IV of the paper.
    """

    dart: base.StandsAt

    kind: ClassVar[str] = "directional"
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.AT_V0, bearing=True)
    default_bound: ClassVar[str] = "paper"
    folds: ClassVar[bool] = True

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Directional]:
        """One place for each bearing ``0..deg(v0)-1``."""
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))


@dataclass(frozen=True)
class Cluster(TowardsNeighbour):
    """One marker at the start vertex v0 and two at a neighbour v1 of it; they point nowhere.

    Sensed: one mark at v0, two at v1; at every vertex the degree.  ``dart`` leads from v0 to
    v1.  With the option ``single=true`` it stands only where exactly one edge joins the two.
    Source: Sections IV and VIII of the paper.
    """

    dart: base.StandsAt
    single: Annotated[
        IfAny[bool], about("whether exactly one edge joins v0 and v1; else false")
    ] = False

    kind: ClassVar[str] = "cluster"
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.AT_V0_AND_V1, bearing=False)

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
        TowardsNeighbour.check(self, map_, start)
        if self.single and self not in self.as_kind.places(map_, start):
            raise InvalidWorld(
                f"lighthouse.dart = {show(self.dart)} leads to a vertex that more than one edge "
                "joins to the start's vertex; single = true asks for exactly one"
            )

    @override
    def references(self, map_: CombinatorialMap) -> Mapping[Dart, int]:
        return {self.dart: 1, map_.alpha[self.dart]: 2}


@dataclass(frozen=True, slots=True)
class Natural(TowardsNeighbour):
    """The start vertex v0 and a neighbour v1 of it; no other vertex has the degree of either.

    Only the degree is sensed.  The explorer is told the degree of v1: that it is unique could
    not be sensed.  ``dart`` is any dart that leads from v0 to v1.
    Source: Section VIII of the paper.
    """

    dart: base.StandsAt

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
        TowardsNeighbour.check(self, map_, start)
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


# ---------------------------------------------------------------- at every vertex


class AtEveryVertex(base.ReferenceLighthouse):
    """A lighthouse with a reference dart at every vertex."""

    darts: tuple[Dart, ...]

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any start
        """Raise InvalidWorld unless the reference darts are one of each vertex."""
        values: Any = self.darts
        if not isinstance(values, list | tuple):
            raise InvalidWorld(f"lighthouse.darts must be a list of darts, not {show(values)}")
        for i, value in enumerate(values):
            if the_integer(f"lighthouse.darts[{i}]", value) not in map_.darts:
                raise InvalidWorld(
                    f"lighthouse.darts names {show(value)}, which is no dart; "
                    f"darts are 0..{len(map_.sigma) - 1}"
                )
        chosen = Counter(map_.vertex_of[dart] for dart in values)
        for v, vertex in enumerate(map_.vertices):
            if chosen[v] != 1:
                raise InvalidWorld(
                    f"lighthouse.darts = {show(list(values))} has {chosen[v]} darts of the vertex "
                    f"{show(list(vertex))}; it must have one of each vertex"
                )


def _first_sensed(walk: base.WalkInAnswer) -> dict[int, tuple[Dart, int]]:
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
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.EVERYWHERE, bearing=True)
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

    @override
    def references(self, map_: CombinatorialMap) -> Mapping[Dart, int]:
        return dict.fromkeys(self.darts, 0)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the reference darts are ascending, one of each vertex."""
        AtEveryVertex.check(self, map_, start)
        if list(self.darts) != sorted(self.darts):
            raise InvalidWorld(f"lighthouse.darts = {show(list(self.darts))} must be ascending")

    def believed(self, map_: CombinatorialMap, start: Dart, walk: base.WalkInAnswer) -> Compass:  # noqa: ARG002  # sensed
        """The compass with the reference darts sensed at the first visit of each vertex."""
        return Compass(tuple(sorted(dart for dart, _ in _first_sensed(walk).values())))

    @override
    def relabelled(self, names: Sequence[Dart]) -> Compass:
        return Compass(tuple(sorted(names[dart] for dart in self.darts)))

    @classmethod
    def at(cls, darts: Any) -> Compass:  # type: ignore[override]  # its only field
        """The compass with these reference darts, in any order."""
        integers = isinstance(darts, list) and are_plain(darts)
        return cls(tuple(sorted(darts)) if integers else darts)

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
        numbers: the numbers of the vertices; empty: 1, 2, 3 ..., as in every world.
    """

    darts: Annotated[
        Some[Dart], about("the reference dart of each vertex, in the order of their numbers")
    ]
    numbers: NotInDocument[tuple[int, ...]] = ()

    kind: ClassVar[str] = "labels"
    labels_vertices: ClassVar[bool] = True
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.EVERYWHERE_NUMBERED, bearing=True)

    @override
    def references(self, map_: CombinatorialMap) -> Mapping[Dart, int]:
        return dict(zip(self.darts, self.numbers or count(1), strict=False))

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Labels]:
        """One place: vertices and their first darts in canonical numbering from ``start``."""
        first: dict[int, Dart] = {}
        for dart in numbering(map_.sigma, map_.alpha, start):
            first.setdefault(map_.vertex_of[dart], dart)
        yield cls(tuple(first.values()))

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the reference darts are one of each vertex, numbered from 1."""
        AtEveryVertex.check(self, map_, start)
        if self.numbers:
            raise InvalidWorld(
                f"the labels {show(list(self.numbers))} are not 1 to {len(self.darts)}"
            )

    def believed(self, map_: CombinatorialMap, start: Dart, walk: base.WalkInAnswer) -> Labels:  # noqa: ARG002  # sensed
        """The labels sensed at the first visit of each vertex; 0 for vertices never visited."""
        darts, numbers = zip(*_first_sensed(walk).values(), strict=True)
        return Labels(darts, numbers)
