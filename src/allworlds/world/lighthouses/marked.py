"""Lighthouses with marks at vertices: at the start, at the start and a neighbour, or everywhere."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import count, islice, product
from typing import Annotated, Any, ClassVar, Literal, TypeAlias

from msgspec import Meta
from typing_extensions import override

from allworlds.documents.document import IfAny, NotInDocument, Some, about
from allworlds.inputs.checks import are_plain, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart, numbering
from allworlds.protocol import actions
from allworlds.world.lighthouses import base
from allworlds.world.lighthouses.options import InvalidWorld, ensure_legal, the_integer

# ---------------------------------------------------------------- at one or two vertices

StartsAt: TypeAlias = Annotated[
    IfAny[Literal["v0", "any"]], about("where the robot starts: `v0`, or anywhere; left out: `v0`")
]


class MarkedStart(base.ReferenceLighthouse):
    """A lighthouse at one vertex v0; a dart of v0 determines what is sensed besides degrees.

    Attributes:
        dart: this dart of v0.
        start: the option ``start`` of some kinds: ``v0``, the robot starts at v0, or ``any``, v0
            may be any vertex.  In methods the parameter ``start`` is another thing: the dart at
            which the robot starts.
    """

    dart: Dart
    start: Any = "v0"

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        if cls.start == "any":
            cls.folds, cls.default_bound = False, "none"

    @classmethod
    def homes(cls, map_: CombinatorialMap, start: Dart) -> Sequence[Dart]:
        """For each vertex that may be v0 the first of its darts in canonical numbering."""
        return [*first_darts(map_, start).values()] if cls.start == "any" else [start]

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[MarkedStart]:
        """Yield a place for each dart of each vertex that may be v0, clockwise."""
        made: Any = cls
        for home in cls.homes(map_, start):
            for bearing in range(map_.degree_at[home]):
                yield made(map_.turn(home, bearing))

    @override
    def references(self, map_: CombinatorialMap) -> Mapping[Dart, int]:
        return {self.dart: 1} if self.sensing.marks else {}

    def legal_darts(self, map_: CombinatorialMap, start: Dart) -> Sequence[Dart]:
        """The darts at which the lighthouse may stand: all darts of each vertex that may be v0."""
        kind: Any = self.as_kind
        homes: Sequence[Dart] = kind.homes(map_, start)
        return [dart for home in homes for dart in map_.vertices[map_.vertex_of[home]]]

    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        """Raise InvalidWorld unless the options and the lighthouse's dart are legal."""
        ensure_legal(self)
        legal = self.legal_darts(map_, start)
        if the_integer("lighthouse.dart", self.dart) not in legal:
            raise InvalidWorld(
                f"the lighthouse {self.written} cannot stand at dart {show(self.dart)} with start "
                f"{start}; legal are {', '.join(map(str, legal)) or 'none'}"
            )


class TowardsNeighbour(MarkedStart):
    """A lighthouse at two vertices: at v0, and at the vertex v1 to which the dart of v0 leads."""

    @override
    def legal_darts(self, map_: CombinatorialMap, start: Dart) -> Sequence[Dart]:
        owner, alpha = map_.vertex_of, map_.alpha
        darts = [placed.dart for placed in self.as_kind.places(map_, start)]  # type: ignore[attr-defined]  # of its kind
        pairs = {(owner[dart], owner[alpha[dart]]) for dart in darts}
        all_ = super().legal_darts(map_, start)
        return [dart for dart in all_ if (owner[dart], owner[alpha[dart]]) in pairs]

    def believed(
        self, map_: CombinatorialMap, start: Dart, walk: base.WalkInAnswer
    ) -> base.Lighthouse | None:
        """The lighthouse at its place in the map of the robot's answer.

        Under ``start=any`` the place has the same number as in the world.  Otherwise the number of
        darts clockwise from the robot's start to the lighthouse's dart is the same in the answer's
        map as in the world.  In a wrong answer the lighthouse may stand illegally at this dart: for
        example, the dart may belong to a loop.  The result is then not None, since this lighthouse
        predicts percepts, too, which the judge can compare.  The parameters are those of
        :meth:`Lighthouse.believed`.
        """
        if self.start == "any":
            return super().believed(map_, start, walk)
        dart = walk.map.turn(walk.trail[0], map_.offset(start, self.dart))
        return replace(self, dart=dart)  # type: ignore[type-var]


@dataclass(frozen=True, slots=True)
class Position(MarkedStart):
    """One marker at the start vertex v0 that points nowhere.

    Sensed at v0: one mark; at every vertex the degree.  ``dart`` is any dart of v0; all darts of v0
    have the same effect.
    Source: Section III of the paper ('unique position information').

    Two lighthouses of this class are equal, even if their darts differ: in a given world every such
    lighthouse stands at the start's vertex.
    """

    dart: base.StandsAt = field(compare=False)

    kind: ClassVar[str] = "position"
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.AT_V0, bearing=False)
    leaves_open: ClassVar[bool] = True

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Position]:  # noqa: ARG003
        """Yield the one place: the start's vertex."""
        yield cls(start)


@dataclass(frozen=True)
class Directional(MarkedStart):
    """One marker at the start vertex v0 that points along one dart of v0.

    Sensed at v0: one mark, and the bearing of ``dart``; elsewhere only the degree.
    Source: Section IV of the paper.
    """

    dart: base.StandsAt
    start: StartsAt = "v0"

    kind: ClassVar[str] = "directional"
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.AT_V0, bearing=True)
    default_bound: ClassVar[str] = "paper"
    folds: ClassVar[bool] = True


def word_of(pattern: str, degree: int) -> tuple[int, ...]:
    """The letters that a pattern gives to the bearings ``0..degree-1``.

    A pattern without ``*`` is repeated if it is too short, and cut off if it is too long.  In a
    pattern with ``*`` only the letter before ``*`` is repeated: as often as needed for ``degree``
    letters in all, perhaps zero times.  If the other letters alone are too many, the end is cut
    off.
    """
    before, star, after = pattern.partition("*")
    if star:
        others = len(before) - 1 + len(after)
        letters = before[:-1] + before[-1] * (degree - others) + after
    else:
        letters = pattern * degree
    return tuple(map(int, letters[:degree]))


class SensedByBearing(MarkedStart):
    """A lighthouse that shows one letter to a robot at v0.

    The bearing of the lighthouse's dart determines the letter.  ``pattern`` gives the letter of
    each bearing; see :func:`word_of`.
    """

    pattern: str

    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.AT_V0, bearing=False)

    @override
    def percepts(self, map_: CombinatorialMap) -> tuple[actions.Percept, ...]:
        letters = word_of(self.pattern, map_.degree_at[self.dart])
        at_v0 = {map_.turn(self.dart, -bearing): mark for bearing, mark in enumerate(letters)}
        return tuple(actions.Percept(map_.degree_at[d], at_v0.get(d, 0)) for d in map_.darts)


@dataclass(frozen=True)
class Door(SensedByBearing):
    """One marked dart of the start vertex v0, sensed only by a robot that has just come in by it.

    Sensed there: one mark; elsewhere, and at v0 by every other dart, only the degree.
    """

    dart: base.StandsAt
    start: StartsAt = "v0"

    kind: ClassVar[str] = "door"
    pattern: ClassVar[str] = "10*"  # type: ignore[misc]  # of a word it is an option


@dataclass(frozen=True)
class Word(SensedByBearing):
    """A letter at each dart of the start vertex v0: one pattern gives the letters in all worlds.

    Sensed at v0: a letter, which is a digit and counts as marks; elsewhere no mark; everywhere the
    degree.  The pattern has the letters for the bearings 0, 1, 2, ... of ``dart``.
    ``word:1`` tells as much as ``position``, ``word:10*`` as ``door``.
    """

    dart: base.StandsAt
    pattern: Annotated[
        str,
        Meta(pattern=r"^[0-9]+\*?[0-9]*$"),
        about("letters for the bearings 0, 1, ..., repeated as needed; `x*`: only x is repeated"),
    ] = "12"

    kind: ClassVar[str] = "word"


@dataclass(frozen=True)
class Cluster(TowardsNeighbour):
    """One marker at the start vertex v0 and two at a neighbour v1 of v0; no marker points.

    Sensed: one mark at v0, two at v1; at every vertex the degree.  ``dart`` leads from v0 to
    v1.  With the option ``single=true`` exactly one edge must join v0 and v1.
    Source: Sections IV and VIII of the paper.
    """

    dart: base.StandsAt
    single: Annotated[
        IfAny[bool], about("whether exactly one edge must join v0 and v1; left out: false")
    ] = False
    start: StartsAt = "v0"

    kind: ClassVar[str] = "cluster"
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.AT_V0_AND_V1, bearing=False)

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Cluster]:
        """Yield a place for each dart of v0 that leads to another vertex, clockwise.

        With the option ``single`` no other edge may join these two vertices.
        """
        for home in cls.homes(map_, start):
            v0 = map_.vertex_of[home]
            around = [map_.turn(home, bearing) for bearing in range(map_.degree_at[home])]
            beyond = {dart: map_.vertex_of[map_.alpha[dart]] for dart in around}
            edges = Counter(beyond.values())
            for dart, v1 in beyond.items():
                if v1 != v0 and (edges[v1] == 1 or not cls.single):
                    yield cls(dart)

    @override
    def references(self, map_: CombinatorialMap) -> Mapping[Dart, int]:
        return {self.dart: 1, map_.alpha[self.dart]: 2}


@dataclass(frozen=True, slots=True)
class Natural(TowardsNeighbour):
    """The start vertex v0 and a neighbour v1 of it; no other vertex has the degree of v0 or of v1.

    The degrees of v0 and v1 differ.  Only the degree is sensed.  The robot senses the degree of v0
    at the start.  The explorer is told the degree of v1, because the robot cannot sense which of
    its neighbours has a degree that occurs only once.  ``dart`` is any dart that leads from v0 to
    v1.
    Source: Section VIII of the paper.
    """

    dart: base.StandsAt

    kind: ClassVar[str] = "natural"

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Natural]:
        """Yield a place for each neighbour that may be v1, at the first dart that leads to it."""
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

    def told(self, map_: CombinatorialMap) -> int:
        """The degree of v1."""
        return map_.degree_at[map_.alpha[self.dart]]


# ---------------------------------------------------------------- at every vertex


def first_darts(map_: CombinatorialMap, start: Dart) -> dict[int, Dart]:
    """For each vertex its first dart in canonical numbering from the start."""
    first: dict[int, Dart] = {}
    for dart in numbering(map_.sigma, map_.alpha, start):
        first.setdefault(map_.vertex_of[dart], dart)
    return first


class AtEveryVertex(base.ReferenceLighthouse):
    """A lighthouse with a reference dart at every vertex."""

    darts: tuple[Dart, ...]

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any start
        """Raise InvalidWorld unless the reference darts are one dart of each vertex."""
        values: Any = self.darts
        if not isinstance(values, list | tuple):
            raise InvalidWorld(f"lighthouse.darts must be a list of darts, not {show(values)}")
        owner = dict(enumerate(map_.vertex_of))
        at = [owner.get(the_integer(f"lighthouse.darts[{i}]", d), -1) for i, d in enumerate(values)]
        if sorted(at) != [*range(map_.vertex_count)]:
            raise InvalidWorld(
                f"lighthouse.darts = {show([*values])}; legal is one dart of each vertex, of "
                f"{show([*map_.vertices])}"
            )


def _first_sensed(walk: base.WalkInAnswer) -> dict[int, tuple[Dart, int]]:
    """For each vertex in the map of the robot's answer a reference dart and a number of marks.

    Dart and number are those that the robot sensed at its first visit of the vertex.  A vertex that
    the robot never visited has its smallest dart and 0 marks.
    """
    answer = walk.map
    found = {vertex: (darts[0], 0) for vertex, darts in enumerate(answer.vertices)}
    for dart, percept in reversed([*zip(walk.trail, walk.sensed, strict=True)]):
        assert percept.bearing is not None
        found[answer.vertex_of[dart]] = (answer.turn(dart, percept.bearing), percept.marks)
    return found


@dataclass(frozen=True, slots=True)
class Compass(AtEveryVertex):
    """At every vertex a reference dart (its north), and no mark: a port-numbered graph.

    Sensed: the degree, and the bearing of the vertex's reference dart.  ``darts`` holds one
    dart of each vertex, ascending.
    Source: Section III of the paper ('global orientation information but no position').
    """

    darts: Annotated[Some[Dart], about("the reference dart of each vertex, ascending")]

    kind: ClassVar[str] = "compass"
    sensing: ClassVar[base.Sensing] = base.Sensing(base.Where.EVERYWHERE, bearing=True)
    every_place_to: ClassVar[int | None] = 3
    beyond: ClassVar[str] = "the compass at the smallest dart of each vertex alone"

    def __post_init__(self) -> None:
        if isinstance(self.darts, list | tuple) and are_plain(self.darts):
            object.__setattr__(self, "darts", tuple(sorted(self.darts)))

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[Compass]:
        """Yield the places: choices of one reference dart at each vertex.

        In maps with up to three edges all choices are yielded; in larger maps only the first.  The
        vertices and their darts are in the order of canonical numbering from ``start``.  So if the
        map itself has canonical numbers, the first choice is the smallest dart of each vertex.
        """
        around: dict[int, list[Dart]] = {}
        for dart in numbering(map_.sigma, map_.alpha, start):
            around.setdefault(map_.vertex_of[dart], []).append(dart)
        assert cls.every_place_to is not None
        wanted = None if map_.edge_count <= cls.every_place_to else 1
        for choice in islice(product(*around.values()), wanted):
            yield cls(choice)

    @override
    def references(self, map_: CombinatorialMap) -> Mapping[Dart, int]:
        return dict.fromkeys(self.darts, 0)

    def believed(self, map_: CombinatorialMap, start: Dart, walk: base.WalkInAnswer) -> Compass:  # noqa: ARG002  # sensed
        """The compass in the map of the robot's answer.

        The reference darts are those that the robot sensed at its first visit of each vertex; an
        unvisited vertex has its smallest dart.  ``walk`` is the robot's walk in the answer's map;
        ``map_`` and ``start`` have no effect.
        """
        return Compass(tuple(dart for dart, _ in _first_sensed(walk).values()))

    @classmethod
    def usual(cls, map_: CombinatorialMap, start: Dart) -> Compass:  # noqa: ARG003  # any start
        """The compass with the smallest dart of each vertex."""
        return cls(tuple(vertex[0] for vertex in map_.vertices))


@dataclass(frozen=True, slots=True)
class Labels(AtEveryVertex):
    """Every vertex has a number of its own, and a reference dart.

    Sensed at a vertex: as many marks as its number, the bearing of its reference dart, and the
    degree.  So the robot can tell all vertices apart.

    Attributes:
        darts: the reference dart of each vertex.  In a world, the first dart is that of the vertex
            with the number 1, the second that of the vertex with the number 2, and so on.
        numbers: empty in a world.  In the map of a robot's answer, :meth:`believed` sets here the
            numbers of the vertices, in the order of ``darts``; vertices that the robot never
            visited have the number 0.
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
        """Yield the only place: numbers and reference darts follow the canonical numbering."""
        yield cls(tuple(first_darts(map_, start).values()))

    def believed(self, map_: CombinatorialMap, start: Dart, walk: base.WalkInAnswer) -> Labels:  # noqa: ARG002  # sensed
        """The lighthouse in the map of the robot's answer.

        Each vertex has the number and the reference dart that the robot sensed at its first visit;
        a vertex that the robot never visited has the number 0.  ``walk`` is the robot's walk in the
        answer's map; ``map_`` and ``start`` have no effect.
        """
        darts, numbers = zip(*_first_sensed(walk).values(), strict=True)
        return Labels(darts, numbers)
