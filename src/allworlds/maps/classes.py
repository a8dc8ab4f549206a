"""**The** tables of the classes of maps and of the conditions that narrow them.

The module has, in this order: the classes; the conditions, and the table of the built-in ones;
extents, which are classes of bounded size under a condition; the options by which requests name
classes, bounds and conditions.

A *gluing* is an unfinished map; the module ``enumeration`` explains how maps are glued together.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import StrEnum
from itertools import groupby
from typing import TYPE_CHECKING, Annotated, Any, Protocol

from msgspec import Struct
from msgspec.structs import force_setattr

from allworlds.documents.document import Bounded, about
from allworlds.inputs.checks import (
    LARGEST_SIZE,
    InputError,
    an_integer,
    at_most,
    integer_of,
    not_one_of,
    one_of,
    show,
)
from allworlds.inputs.requests import SCOPE, Converted, Option, Request
from allworlds.maps.combinatorial import CombinatorialMap, cycles

if TYPE_CHECKING:
    from allworlds.maps.enumeration import Gluing

DEFAULT_EDGES = 5
"""The default bound on the number of edges; a check of all maps within it takes seconds."""


class MapClass(StrEnum):
    """A class of maps; the value of a member is the name of the class on the command line."""

    MAPS = "maps"
    SIMPLE = "simple"
    PLANAR = "planar"
    PLANAR_SIMPLE = "planar-simple"

    @classmethod
    def named(cls, text: object) -> MapClass:
        """Return the class with the name ``text``.

        Raises:
            InputError: naming all classes, if ``text`` is not the name of one.
        """
        if not isinstance(text, str) or text not in list(cls):
            raise not_one_of("class", text, cls)
        return cls(text)

    @property
    def summary(self) -> str:
        """A description of the maps of the class in a few words."""
        return _SUMMARIES[self]

    @property
    def simple(self) -> bool:
        """Whether loops and parallel edges are excluded."""
        return self in (MapClass.SIMPLE, MapClass.PLANAR_SIMPLE)

    @property
    def planar(self) -> bool:
        """Whether the genus of every map is 0."""
        return self in (MapClass.PLANAR, MapClass.PLANAR_SIMPLE)

    def includes(self, map_: CombinatorialMap) -> bool:
        """Whether a map belongs to the class; its loops, parallel edges and genus decide."""
        return (not self.simple or map_.is_simple) and (not self.planar or map_.is_planar)


_SUMMARIES = {
    MapClass.MAPS: "loops and parallel edges are allowed, and any genus",
    MapClass.SIMPLE: "no loop, no two edges with the same ends",
    MapClass.PLANAR: "of genus 0",
    MapClass.PLANAR_SIMPLE: "of genus 0, no loop, no two edges with the same ends",
}


# ---------------------------------------------------------------- conditions


class Condition(Protocol):
    """A property of maps that does not depend on the numbering of darts.

    A condition is built in (:class:`NamedCondition`), a user's own, or several conditions at once
    (:class:`AllOf`).
    """

    @property
    def name(self) -> str:
        """The name of the property, as the option ``--where`` takes it."""

    def holds(self, map_: CombinatorialMap) -> bool:
        """Whether the map has the property."""


AND = " and "
"""The text that separates the names of several conditions."""

LEGAL = "cubic, regular:D, eulerian, trees, girth:G, genus:G, triangulation, quadrangulation"
"""The forms of the names of all built-in conditions, for messages."""


class NamedCondition(Struct, frozen=True):
    """A built-in condition; its name may hold a number, as in ``girth:4``."""

    name: str

    def holds(self, map_: CombinatorialMap) -> bool:
        """Whether the map has the property."""
        return self._kind.holds(map_, self.number)

    @property
    def dual(self) -> bool:
        """Whether this condition is tested on unfinished duals, and not on unfinished maps.

        The dual of a map has a vertex for each face of the map.  A condition on the faces of a map
        is one on the vertices of its dual, so it can be tested before the dual is finished.
        Therefore the enumeration glues together the duals, and turns each finished dual into its
        map.
        """
        return self._kind.dual

    def may_begin(self, gluing: Gluing) -> bool:
        """Whether the unfinished map ``gluing`` can become a map with the property.

        If :attr:`dual` is true: whether ``gluing`` can become the dual of a map with the property.
        """
        return self._kind.begins(gluing, self.number)

    @property
    def kind(self) -> str:
        """The name without its number."""
        return self.name.partition(":")[0]

    @property
    def number(self) -> int:
        """The number in the name; 0 if there is none."""
        return int(self.name.partition(":")[2] or 0)

    @property
    def _kind(self) -> ConditionKind:
        return CONDITIONS[self.kind]

    def __str__(self) -> str:
        return self.name


class AllOf(Struct, frozen=True):
    """Several conditions, each of which must hold."""

    parts: tuple[Condition, ...]

    @property
    def name(self) -> str:
        """The names of the single conditions, joined by :data:`AND`."""
        return AND.join(part.name for part in self.parts)

    @property
    def codes(self) -> tuple[Any, ...]:
        """The user's own code of the single conditions; empty if all conditions are built in.

        Each element is a ``UserCode`` of the module ``protocol.user_code``.
        """
        return tuple(code for part in self.parts for code in getattr(part, "codes", ()))

    def holds(self, map_: CombinatorialMap) -> bool:
        """Whether the map has all properties."""
        return all(part.holds(map_) for part in self.parts)

    def __str__(self) -> str:
        return self.name


def narrowing(where: Condition | None) -> tuple[NamedCondition, ...]:
    """The conditions in ``where`` that the enumeration tests on unfinished maps.

    The enumeration gives up an unfinished map that cannot meet one of these conditions.  Only
    built-in conditions can be tested so; a user's condition is tested on finished maps alone.  Some
    built-in conditions are tested on unfinished maps, and some on unfinished duals
    (:attr:`NamedCondition.dual`), but the enumeration glues together either maps or duals.  So if
    ``where`` holds conditions of both kinds, the result holds only those that are tested on maps.
    """
    parts = where.parts if isinstance(where, AllOf) else (where,)
    found = [part for part in parts if isinstance(part, NamedCondition)]
    return tuple([part for part in found if not part.dual] or found)


def condition_named(text: str) -> NamedCondition | None:
    """The built-in condition with the name ``text``; None if there is no such condition.

    Raises:
        InputError: if the number in the name is missing, is too small, or is not a number.
    """
    name, colon, number = text.partition(":")
    if name not in CONDITIONS:
        return None
    least = CONDITIONS[name].least
    if least is None:
        if colon:
            raise InputError(f"where = {show(text)}: {name} takes no number; legal are {LEGAL}")
    elif not re.fullmatch("[0-9]{1,6}", number) or int(number) < least:
        raise InputError(
            f"where = {show(text)}: {name} takes a number from {least} on, as in {name}:3"
        )
    return NamedCondition(text)


# ---------------------------------------------------------------- the conditions with a name


OPEN = -1


class ConditionKind(Struct, frozen=True):
    """The functions of a built-in condition; they serve all numbers that its name can hold.

    For example, one object is for ``girth:3``, ``girth:4`` and so on.  If the name has no number,
    the functions get the number 0, which they ignore.

    Attributes:
        holds: the function that tells, for a map and the number in the name, whether the map meets
            the condition.
        begins: the function that tells, for an unfinished map and the number, whether this map can
            still become a map that meets the condition.
        least: the least legal number; None if the name has no number.
        dual: whether ``begins`` takes an unfinished dual instead of an unfinished map: see
            :attr:`NamedCondition.dual`.
    """

    holds: Callable[[CombinatorialMap, int], bool]
    begins: Callable[[Gluing, int], bool]
    least: int | None = None
    dual: bool = False


def girth(map_: CombinatorialMap) -> int | None:
    """The length of a shortest cycle; None for a tree.

    A loop is a cycle of length 1; two parallel edges are a cycle of length 2.
    Cost: O(m) for each dart.
    """
    owner, alpha = map_.vertex_of, map_.alpha
    shortest: int | None = None
    for d, e in map_.edges:

        def beyond(vertex: int, edge: tuple[int, int] = (d, e)) -> list[int]:
            return [owner[alpha[x]] for x in map_.vertices[vertex] if x not in edge]

        most = map_.edge_count if shortest is None else shortest - 1
        shortest = _shortest_round(owner[d], owner[e], beyond, most) or shortest
    return shortest


def regular(gluing: Gluing, degree: int) -> bool:
    """Whether ``gluing`` may still become a map whose vertices all have the degree ``degree``.

    The result is true if three conditions hold.  First: all vertices of ``gluing`` have this
    degree.  Second: the number of darts that must still be made is a multiple of the degree.
    Third: with the vertices for these darts, the gluing has at most ``gluing.limit`` vertices.
    """
    room = gluing.limit - len(gluing.degrees)
    return (
        all(met == degree for met in gluing.degrees)
        and gluing.owed % degree == 0
        and gluing.owed <= room * degree
    )


def even(gluing: Gluing, _number: int) -> bool:
    """Whether all vertices of ``gluing`` have even degrees."""
    return not any(degree % 2 for degree in gluing.degrees)


def tree(gluing: Gluing, _number: int) -> bool:
    """Whether ``gluing`` can become a tree.

    Each edge so far must have led to a new vertex, and each open dart must be able to lead to one.
    """
    open_darts = sum(map(len, gluing.faces))
    edges = (len(gluing.alpha) - open_darts) // 2
    return (
        edges == len(gluing.degrees) - 1
        and open_darts <= gluing.owed
        and gluing.limit == gluing.edges + 1
    )


def girth_at_least(gluing: Gluing, least: int) -> bool:
    """Whether the newest edge of ``gluing`` closes no cycle of fewer than ``least`` edges."""
    dart = gluing.newest
    if dart == OPEN:
        return True
    other, vertex = gluing.alpha[dart], gluing.vertex
    beyond: list[set[int]] = [set() for _ in gluing.degrees]
    for d, e in enumerate(gluing.alpha):
        if e != OPEN and d not in (dart, other):
            beyond[vertex[d]].add(vertex[e])
    return _shortest_round(vertex[dart], vertex[other], beyond.__getitem__, least - 1) is None


def _shortest_round(
    start: int, goal: int, beyond: Callable[[int], Iterable[int]], most: int
) -> int | None:
    """The length of a shortest cycle through a given edge, which joins ``start`` and ``goal``.

    The length is a number of edges, the given edge included; the result is None if the length is
    more than ``most``.  ``beyond`` is a function that takes a vertex, and returns the vertices at
    the other ends of its edges, the given edge left out.
    """
    ring, met = {start}, {start}
    for length in range(1, most + 1):
        if goal in ring:
            return length
        ring = {w for vertex in ring for w in beyond(vertex)} - met
        if not ring:
            break
        met |= ring
    return None


def genus_exactly(gluing: Gluing, genus: int) -> bool:
    """Whether ``gluing`` can become a map of the genus ``genus``.

    When further edges are glued, the genus never falls; so the genus of the edges so far must be at
    most ``genus``.  A finished map with n vertices and m edges has at least one face, so
    ``2 * genus <= m - n + 1``.
    """
    vertices = len(gluing.degrees)
    most = (gluing.edges - vertices - (gluing.owed > 0) + 1) // 2
    if genus > most:
        return False
    closed = [d for d, e in enumerate(gluing.alpha) if e != OPEN]
    following: dict[int, int] = {}
    for _, group in groupby(closed, gluing.vertex.__getitem__):
        around = [*group]
        following.update(zip(around, [*around[1:], around[0]], strict=True))
    number = {dart: i for i, dart in enumerate(closed)}
    faces = len(cycles([number[following[gluing.alpha[dart]]] for dart in closed]))
    return not closed or 2 - vertices + len(closed) // 2 - faces <= 2 * genus


def _faces_of(length: int) -> ConditionKind:
    """The condition that all faces have ``length`` darts."""
    return ConditionKind(
        lambda m, _: all(len(face) == length for face in m.faces),
        lambda dual, _: regular(dual, length),
        dual=True,
    )


CONDITIONS: dict[str, ConditionKind] = {
    "cubic": ConditionKind(lambda m, _: {*m.degrees} == {3}, lambda g, _: regular(g, 3)),
    "regular": ConditionKind(lambda m, d: {*m.degrees} == {d}, regular, 1),
    "eulerian": ConditionKind(lambda m, _: not any(d % 2 for d in m.degrees), even),
    "trees": ConditionKind(lambda m, _: m.edge_count == m.vertex_count - 1, tree),
    "girth": ConditionKind(lambda m, g: (girth(m) or g) >= g, girth_at_least, 1),
    "genus": ConditionKind(lambda m, g: m.genus == g, genus_exactly, 0),
    "triangulation": _faces_of(3),
    "quadrangulation": _faces_of(4),
}
"""The built-in conditions, by their names without numbers."""

# ---------------------------------------------------------------- classes of a size


class MapSource(Protocol):
    """Maps that are given one by one, instead of all maps of a class.

    Attributes:
        starts: how many rooted maps are given.  The keys are numbers of edges, ascending; the value
            is the number of the given rooted maps with so many edges.  A map with several given
            starts is several rooted maps.
        count: the number of the given maps; a map with several starts counts once.
        fixed: whether each map comes with a single start and a single place of its lighthouse.
        words: words about the number and the origin of the maps, for messages.
        gate: a text that a report shows instead of the gate.  It says why there is no number with
            which the number of the maps can be compared.
    """

    starts: Mapping[int, int]
    count: int
    fixed: bool
    words: str
    gate: str

    def like(self, world: Any) -> Iterable[Any]:
        """Return the given worlds that equal the world ``world`` up to the numbering of darts.

        A result has the numbering of darts with which it was given; if it was given without a
        lighthouse, it gets that of ``world``.  The results are in the order in which they were
        given.
        """


class Extent(Struct, frozen=True):
    """The maps of one class with at most ``edges`` edges and at most ``vertices`` vertices.

    Attributes:
        map_class: the class.
        edges: the largest number of edges; None if only the vertices are bounded, which is legal
            for simple classes.  With given maps the field is never None: in place of None it gets
            the largest number of edges of the given maps.
        vertices: the largest number of vertices; None if only the edges are bounded.
        where: a condition that the maps meet; None if there is none.
        given: the given maps, of which those in the class and within the bounds are taken; None for
            all maps of the class.

    Raises:
        InputError: naming the offending bound and what would be legal.
    """

    map_class: MapClass
    edges: int | None
    vertices: int | None = None
    where: Condition | None = None
    given: MapSource | None = None

    def __post_init__(self) -> None:
        if self.given is not None and self.edges is None:
            force_setattr(self, "edges", max(self.given.starts))
        for name in ("edges", "vertices"):
            if (value := getattr(self, name)) is not None:
                force_setattr(self, name, an_integer(name, value))
                at_most(name, value, LARGEST_SIZE)
        if self.edges is not None and self.edges < 1:
            raise InputError(f"edges = {show(self.edges)}, but a map has at least 1 edge")
        if self.given is not None and not self.levels:
            least = min(self.given.starts)
            raise InputError(
                f"edges = {self.edges}, but {self.given.words} have at least {least} edges"
            )
        least = 1 + self.map_class.simple
        if self.vertices is not None and self.vertices < least:
            raise InputError(
                f"vertices = {show(self.vertices)}, but a map of the class '{self.map_class}' has "
                f"at least {least}"
            )
        if self.edges is None and (self.vertices is None or not self.map_class.simple):
            alone = f"; vertices = {self.vertices} alone is none here" if self.vertices else ""
            bounds = "edges, or vertices for the simple classes"
            raise InputError(f"the class '{self.map_class}' needs a bound: {bounds}{alone}")

    @property
    def levels(self) -> Sequence[int]:
        """The numbers of edges that maps of the extent may have, ascending: its levels."""
        if self.given is not None:
            assert self.edges is not None
            return [edges for edges in self.given.starts if edges <= self.edges]
        if self.edges is not None:
            return range(1, self.edges + 1)
        assert self.vertices is not None
        return range(1, self.vertices * (self.vertices - 1) // 2 + 1)

    def vertex_limit(self, edges: int) -> int:
        """The largest number of vertices of a map with ``edges`` edges within the bounds."""
        return edges + 1 if self.vertices is None else min(edges + 1, self.vertices)

    def include(self, map_: CombinatorialMap) -> bool:
        """Whether a map belongs to the class, is within the bounds, and meets the condition."""
        edges, vertices = map_.edge_count, map_.vertex_count
        within = edges in self.levels and vertices <= self.vertex_limit(edges)
        return within and self.map_class.includes(map_) and self.admits(map_)

    def admits(self, map_: CombinatorialMap) -> bool:
        """Whether a map meets the condition; true without a condition."""
        return self.where is None or self.where.holds(map_)


# ---------------------------------------------------------------- as requests ask for it


class ClassOptions(Request):
    """The part of a request that names a class of maps."""

    map_class: Annotated[
        Converted[str, MapClass],
        Option(
            SCOPE,
            "CLASS",
            f"{one_of(MapClass)}.",
            "class",
            document_type=Annotated[MapClass, about("the class of maps")],
        ),
    ] = Converted(MapClass.named, MapClass.MAPS.value)


class SizeOptions(Request):
    """The part of a request that bounds the size of maps."""

    edges: Annotated[
        int | None, Option(SCOPE, "M", "At most M edges.", parse=integer_of, document_type=Bounded)
    ] = None
    vertices: Annotated[
        int | None,
        Option(
            SCOPE,
            "N",
            "At most N vertices (alone: simple classes only; default: any).",
            parse=integer_of,
            document_type=Bounded,
        ),
    ] = None


class ExtentOptions(ClassOptions, SizeOptions):
    """The part of a request that names a class of maps and bounds their size."""

    @property
    def extent(self) -> Extent:
        """The extent: the class with its bounds, its condition, and the given maps.

        Raises:
            InputError: naming the offending bound and what would be legal.
        """
        return Extent(self.map_class, self.edges, self.vertices, self.condition, self.given)

    @property
    def condition(self) -> Condition | None:
        """The condition that narrows the class of maps; None if there is none.

        This class has no condition; a subclass that has one overrides the property.
        """
        return None

    @property
    def given(self) -> MapSource | None:
        """The given maps; None if the request takes all maps of a class.

        This class takes all maps; a subclass that can take given maps overrides the property.
        """
        return None
