"""The question of a search, checked once: lighthouse, class, bounds and the walk."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from msgspec import Struct

from allworlds.inputs.checks import LARGEST_SIZE, InputError, a_text, an_integer, at_most, show
from allworlds.maps.classes import MapClass
from allworlds.maps.combinatorial import Dart
from allworlds.studies.ambiguity.ambiguity_requests import SearchRequest
from allworlds.studies.ambiguity.smt.one_world import Degrees, Size
from allworlds.words import plural
from allworlds.world.lighthouses.base import Lighthouse, ReferenceLighthouse, Sensing
from allworlds.world.lighthouses.kinds import LIGHTHOUSES
from allworlds.world.lighthouses.marked import Compass, Directional, Position
from allworlds.world.lighthouses.placeless import Nothing

SEARCHED: Mapping[str, Callable[[Sequence[Dart]], Lighthouse]] = {
    Nothing.kind: lambda _: Nothing(),
    Position.kind: lambda _: Position(0),
    Directional.kind: lambda darts: Directional(darts[0]),
    Compass.kind: lambda darts: Compass(tuple(darts)),
}
"""The lighthouses of which there are formulas, with start 0 and the darts that they point to."""

ANY = Degrees()
"""No requirement on degrees."""


class Sensed(NamedTuple):
    """A percept as the caption of Fig. 1 writes it: ``3A`` or ``4P``; ``present`` at v0."""

    degree: int
    present: bool


class Walk(Struct, frozen=True):
    """Motions from the start, and the percept after each of them.

    Raises:
        InputError: if there are not equally many.
    """

    motions: tuple[int, ...] = ()
    percepts: tuple[Sensed, ...] = ()

    def __post_init__(self) -> None:
        if len(self.motions) != len(self.percepts):
            raise InputError(
                f"{len(self.motions)} motions and {len(self.percepts)} percepts, but there is "
                "one percept after each motion"
            )


NOWHERE = Walk()
"""No walk."""


def percept_named(text: str) -> Sensed:
    """The percept of ``3A`` (degree 3, marker absent) or ``4P`` (degree 4, marker present).

    Raises:
        InputError: naming the text and what would be legal.
    """
    bare = a_text("percept", text).strip().strip("[]").replace(",", "")
    match = re.fullmatch(r"([1-9][0-9]{0,8})([AP]*)", bare)
    if match is None or not match[2]:
        raise InputError(
            f"percept {show(text)} is not of the form 3A (marker absent) or 4P (present)"
        )
    if match[2].count("P") > 1:
        raise InputError(
            f"percept {show(text)} has {match[2].count('P')} position markers, but a world has one"
        )
    if len(match[2]) > 1:
        raise InputError(f"percept {show(text)} says more than once whether the marker is there")
    return Sensed(int(match[1]), match[2] == "P")


class Sizes(NamedTuple):
    """The sizes of the two worlds of one formula."""

    one: Size
    two: Size

    @property
    def name(self) -> str:
        """Name for files: ``m4`` or ``m3-m4``, with the numbers of vertices."""
        sizes = [self.one] if self.one == self.two else [self.one, self.two]
        return "-".join(
            f"m{size.edges}n{size.fewest}" + (f"to{size.most}" if size.most > size.fewest else "")
            for size in sizes
        )


class Question(Struct, frozen=True):
    """Is there a pair of different worlds that no motion separates?

    Attributes:
        lighthouse: its kind.
        map_class: of both worlds.
        vertices, edges: of each of them.
        degrees: of v0, the start's vertex, and of all others.
        walk: what a walk from the start senses, in both worlds.

    Raises:
        InputError: naming the offending bound or percept.
    """

    lighthouse: str
    map_class: MapClass
    vertices: int
    edges: int
    degrees: Degrees = ANY
    walk: Walk = NOWHERE

    def __post_init__(self) -> None:
        for name, value in (("vertices", self.vertices), ("edges", self.edges)):
            if an_integer(f"{name}", value) < 1:
                raise InputError(f"{name} = {show(value)}, but a map has at least 1")
            at_most(name, value, LARGEST_SIZE)
        for name, degree in (("marked", self.degrees.root), ("others", self.degrees.others)):
            if degree is not None and an_integer(f"degree-{name}", degree) < 1:
                raise InputError(
                    f"degree-{name} = {show(degree)}, but every vertex has at least 1 dart"
                )
        if not self.sensing.marks_v0:
            for percept in self.walk.percepts:
                if percept.present:
                    raise InputError(
                        f"percept {percept.degree}P needs a marked vertex, but there is none with "
                        f"--lighthouse {self.lighthouse}; legal is {percept.degree}A"
                    )

    @property
    def sensing(self) -> Sensing:
        """The kind of marker that is sensed besides the degree."""
        kind = LIGHTHOUSES[self.lighthouse]
        assert issubclass(kind, ReferenceLighthouse)
        return kind.sensing

    def sizes(self) -> Iterator[Sizes]:
        """The pairs of sizes that are to be searched, the smaller first.

        Where a vertex is marked, worlds that look alike have equally many edges: exactly one
        dart class lies over each dart of v0's quotient, and its size is the same for all.
        Elsewhere the sizes are ordered by the larger number of edges, then by the smaller.
        Sizes for which simple counting leaves no world are left out.
        """
        sizes = [size for m in range(1, self.edges + 1) if (size := self._size(m))]
        for two in sizes:
            for one in sizes:
                if one.edges == two.edges or (one.edges < two.edges and not self.sensing.marks_v0):
                    yield Sizes(one, two)

    def _size(self, edges: int) -> Size | None:
        numbers = [n for n in range(1, self.vertices + 1) if self._possible(edges, n)]
        return Size(edges, numbers[0], numbers[-1]) if numbers else None

    def _possible(self, m: int, n: int) -> bool:
        root, others = self.degrees.root, self.degrees.others
        if n > m + 1:
            return False
        if self.map_class.simple and (n < 2 or m > n * (n - 1) // 2):
            return False
        if self.map_class is MapClass.PLANAR_SIMPLE and n >= 3 and m > 3 * n - 6:
            return False
        if root is not None and root > 2 * m - (n - 1):
            return False
        if root is not None and others is not None:
            return 2 * m == root + others * (n - 1)
        if others is not None:
            return 2 * m > others * (n - 1)
        return True

    @property
    def describes(self) -> str:
        """The question as a sentence, for comments in files."""
        extra = [
            f"at most {plural(self.vertices, 'vertex', 'vertices')}",
            f"at most {plural(self.edges, 'edge')}",
        ]
        if self.degrees.root is not None:
            extra.append(f"degree {self.degrees.root} at the start's vertex")
        if self.degrees.others is not None:
            extra.append(f"degree {self.degrees.others} elsewhere")
        if self.walk.motions:
            seen = ", ".join(f"{p.degree}{'P' if p.present else 'A'}" for p in self.walk.percepts)
            extra.append(f"motions {', '.join(map(str, self.walk.motions))} sensing {seen}")
        return (
            f"Two different worlds that no motion tells apart: lighthouse {self.lighthouse}, "
            f"class {self.map_class}, {', '.join(extra)}"
        )


def _listed(name: str, values: object) -> Sequence[Any]:
    if not isinstance(values, Sequence) or isinstance(values, str):
        raise InputError(f"{name} = {show(values)} is not a list")
    return values


def question_of(request: SearchRequest) -> Question:
    """The question that a request asks.

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    if request.lighthouse not in SEARCHED:
        legal = ", ".join(SEARCHED)
        raise InputError(
            f"lighthouse {show(request.lighthouse)} is not one of {legal}, of which there are "
            "formulas; 'ambiguity census' takes every lighthouse, and makes all small worlds"
        )
    motions, percepts = _listed("motions", request.motions), _listed("percepts", request.percepts)
    return Question(
        request.lighthouse,
        request.map_class,
        request.vertices,
        request.edges,
        Degrees(request.degree_marked, request.degree_others),
        Walk(
            tuple(an_integer("motion", k) for k in motions),
            tuple(percept_named(text) for text in percepts),
        ),
    )
