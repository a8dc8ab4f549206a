"""The question of a search for twins: the properties that the two worlds must have.

The properties are lighthouse, class, bounds and walk.  Illegal values are refused.
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Annotated, NamedTuple

from msgspec import Struct

from allworlds.engines.limits import TimeLimitOptions
from allworlds.inputs.checks import (
    LARGEST_SIZE,
    InputError,
    a_text,
    an_integer,
    at_most,
    integer_of,
    not_one_of,
    show,
)
from allworlds.inputs.requests import EFFORT, OUTPUT, SCOPE, Option
from allworlds.maps import classes, combinatorial
from allworlds.maps.build import named_map
from allworlds.maps.enumeration import rooted_maps
from allworlds.studies.options import ListenerOptions
from allworlds.words import plural
from allworlds.world.lighthouses import base, composed, kinds, marked
from allworlds.world.selection import TRIED_EDGES, tried_kind


def motion_list(text: str) -> tuple[int, ...]:
    """The motions in a text such as ``1,-1,0``.

    Raises:
        InputError: if the text does not consist of integers with commas between.
    """
    if not re.fullmatch(r"-?[0-9]{1,3}(,-?[0-9]{1,3})*", text):
        raise InputError(f"motions {show(text)} are not integers of up to 3 digits with commas")
    return tuple(int(part) for part in text.split(","))


class SearchRequest(ListenerOptions, TimeLimitOptions, classes.ClassOptions):
    """Request of ``ambiguity search``: the properties of the twins, and the solver."""

    lighthouse: Annotated[
        str,
        Option(
            SCOPE,
            "KIND",
            "The lighthouse, sensed besides degrees: none, position, compass, directional, door, "
            "word:PATTERN, or FILE.py:Class with marks at v0 alone.",
        ),
    ]
    vertices: Annotated[int, Option(SCOPE, "N", "At most N vertices.", parse=integer_of)]
    edges: Annotated[int, Option(SCOPE, "M", "At most M edges.", parse=integer_of)]
    degree_marked: Annotated[
        int | None, Option(SCOPE, "D", "Degree of the start's vertex.", parse=integer_of)
    ] = None
    degree_others: Annotated[
        int | None, Option(SCOPE, "D", "Degree of every other vertex.", parse=integer_of)
    ] = None
    motions: Annotated[
        Sequence[int], Option(SCOPE, "K,K,...", "A walk from the start.", parse=motion_list)
    ] = ()
    percepts: Annotated[
        Sequence[str],
        Option(
            SCOPE,
            "P,P,...",
            "Percepts after each motion: 3A (degree 3, marker absent) or 4P (present).",
            parse=lambda text: tuple(text.split(",")),
        ),
    ] = ()
    solver: Annotated[
        str | None,
        Option(
            EFFORT,
            "PATH",
            "The program CaDiCaL, version 2 or later, in place of z3; it also writes the proofs.",
            apart=True,
        ),
    ] = None
    out: Annotated[
        str | Path | None,
        Option(
            OUTPUT,
            "DIR",
            "The directory for formulas and proofs (default: a new temporary directory).",
            apart=True,
        ),
    ] = None


SEARCHED: Mapping[str, Callable[[Sequence[combinatorial.Dart]], base.Lighthouse]] = {
    composed.Nothing.kind: lambda _: composed.Nothing(),
    marked.Position.kind: lambda _: marked.Position(0),
    marked.Directional.kind: lambda darts: marked.Directional(darts[0]),
    marked.Compass.kind: lambda darts: marked.Compass(tuple(darts)),
}
"""Functions, by kind of lighthouse; each makes a lighthouse of its kind from the reference darts.

A reference dart is one to which bearings are counted.  For the kinds in this table the formulas say
which darts are reference darts.  For all other kinds the formulas say which letters are at the
darts of v0; a letter is a mark that depends on the bearing.  In these formulas the start has
bearing 0, since a robot turns without cost: it may as well start at any dart of v0.
"""

LETTERS = (marked.Door.kind, marked.Word.kind)


class Step(NamedTuple):
    """A motion, and the percept after the motion: the degree, and whether a marker is present."""

    motion: int
    degree: int
    present: bool

    @property
    def percept(self) -> str:
        """``3A`` or ``4P``: the degree, and whether the marker is absent or present."""
        return f"{self.degree}{'P' if self.present else 'A'}"


class Size(Struct, frozen=True):
    """The size of a world: exactly ``edges`` edges, and from ``fewest`` to ``most`` vertices."""

    edges: int
    fewest: int
    most: int

    @property
    def darts(self) -> int:
        """The number of darts, 2m."""
        return 2 * self.edges


class Sizes(NamedTuple):
    """The sizes of the two worlds of one formula."""

    one: Size
    two: Size

    @property
    def name(self) -> str:
        """The name for files: for example ``m4n2to5``, or ``m3n2-m4n3`` if the two sizes differ."""
        return "-".join(
            f"m{size.edges}n{size.fewest}" + (f"to{size.most}" if size.most > size.fewest else "")
            for size in dict.fromkeys(self)
        )


class Question(Struct, frozen=True, dict=True):
    """A question: is there a pair of different worlds that no motion tells apart?

    Attributes:
        lighthouse: the kind of the lighthouse.
        map_class: the class of both maps.
        vertices, edges: the largest numbers of vertices and of edges of each world.
        degree_marked: the degree of v0, the vertex of the start; None: any.
        degree_others: the degree of all other vertices; None: any.
        walk: motions from the start, each with the percept after it; in both worlds a robot must
            sense these percepts.
    """

    lighthouse: str
    map_class: classes.MapClass
    vertices: int
    edges: int
    degree_marked: int | None = None
    degree_others: int | None = None
    walk: tuple[Step, ...] = ()

    @property
    def sensing(self) -> base.Sensing:
        """The vertices with more than a degree to sense, and whether bearings are sensed there.

        For the kinds in :data:`SEARCHED`, such as ``position`` and ``compass``, the result is the
        attribute ``sensing`` of the lighthouse's Python class.

        Under any other lighthouse a robot senses letters at the darts of v0, and no bearings.  If
        every word has a letter that is not 0, the robot recognises v0 by the letters, and the
        result names v0 alone.  If for some degree all letters are 0, a v0 of this degree may look
        like another vertex.  Then the result names no vertex, so no formula assumes that the robot
        recognises v0.
        """
        kind, shown = self.kind, all(map(any, self.words.values()))  # else v0 may look like others
        if shown and issubclass(kind, base.ReferenceLighthouse):
            return kind.sensing
        return base.Sensing(base.Where.AT_V0 if shown else base.Where.NOWHERE, bearing=False)

    @property
    def kind(self) -> type[base.Lighthouse]:
        """The class of the lighthouse."""
        return kinds.lighthouse_kind(self.lighthouse).as_class

    @cached_property
    def words(self) -> Mapping[int, tuple[int, ...]]:
        """The word of v0, by the degree of v0: the letters at the bearings 0, 1 and so on.

        A letter is the number of marks that a robot senses at a dart of v0.  There are no words for
        the kinds in :data:`SEARCHED`, such as ``position``: their formulas speak of markers and
        reference darts.

        The word for degree d is read from a star: a map in which d edges lead from v0 to vertices
        of degree 1.  The lighthouse is at the first place that it yields for the star.  A degree is
        missing if there is no such place.

        The letter at a dart depends on the degree of v0 and the bearing of the dart alone.  So
        another map has the same word, and another place in the map only turns the word.  If the
        lighthouse is a user's, :func:`question_of` tests in small maps whether the letters depend
        on nothing else.
        """
        if self.lighthouse in SEARCHED:
            return {}
        stars = [named_map(f"star-{d}") for d in range(1, 2 * self.edges + 1)]
        first = {map_: [*self.kind.places(map_, 0)][:1] for map_ in stars}
        return {map_.edge_count: letters_at(on[0], map_) for map_, on in first.items() if on}

    def sizes(self) -> Iterator[Sizes]:
        """Yield the pairs of sizes to search, the smallest first.

        If a marker shows v0, both sizes of a pair are equal, because two worlds that look alike
        have equally many darts.  The reason is that they have the same quotient.  In each of the
        two worlds all classes of darts have equally many darts, say k.  All darts in the class of
        the start are at v0, so k is the degree of v0 divided by the number of classes at v0.  The
        quotient shows both of these numbers, so k is the same number in both worlds.

        Otherwise the pairs are ordered by the larger number of edges, then by the smaller number.

        A size is left out if its numbers of edges and vertices show that no world has this size;
        see :meth:`_possible`.
        """
        sizes = []
        for m in range(1, self.edges + 1):
            if numbers := [n for n in range(1, self.vertices + 1) if self._possible(m, n)]:
                sizes.append(two := Size(m, numbers[0], numbers[-1]))
                for one in sizes[-1:] if self.sensing.marks_v0 else sizes:
                    yield Sizes(one, two)

    def _possible(self, m: int, n: int) -> bool:
        """Whether worlds with m edges and n vertices can exist, by simple counting."""
        root, others = self.degree_marked, self.degree_others
        if n > m + 1:
            return False
        if self.map_class.simple and (n < 2 or m > n * (n - 1) // 2):
            return False
        if self.map_class is classes.MapClass.PLANAR_SIMPLE and n >= 3 and m > 3 * n - 6:
            return False
        if root is not None and root > 2 * m - (n - 1):
            return False
        if root is not None and others is not None:
            return 2 * m == root + others * (n - 1)
        return others is None or 2 * m > others * (n - 1)

    @property
    def describes(self) -> str:
        """The question as a sentence, for comments in files."""
        extra = [
            f"at most {plural(self.vertices, 'vertex', 'vertices')}",
            f"at most {plural(self.edges, 'edge')}",
        ]
        if self.degree_marked is not None:
            extra.append(f"degree {self.degree_marked} at the start's vertex")
        if self.degree_others is not None:
            extra.append(f"degree {self.degree_others} elsewhere")
        if self.walk:
            motions = ", ".join(str(step.motion) for step in self.walk)
            seen = ", ".join(step.percept for step in self.walk)
            extra.append(f"motions {motions} sensing {seen}")
        return (
            f"Two different worlds that no motion tells apart: lighthouse {self.lighthouse}, "
            f"class {self.map_class}, {', '.join(extra)}"
        )


def letters_at(placed: base.Lighthouse, map_: combinatorial.CombinatorialMap) -> tuple[int, ...]:
    """The marks that a robot senses at the darts of v0, at the bearings 0, 1 and so on.

    ``placed`` is the lighthouse at a place in the map.  Here the bearing of a dart is the number of
    darts clockwise from this dart to dart 0, which is a dart of v0.  So the letters are those of
    dart 0, then of the dart before it, and so on.
    """
    seen = placed.percepts(map_)
    return tuple(seen[map_.turn(0, -bearing)].marks for bearing in range(map_.degree_at[0]))


def _ensure_at_v0(question: Question) -> None:
    """Raise InputError if a robot knows more than degrees and the letters at v0.

    More would be marks elsewhere, a bearing, or a value that is told before the start.  The
    lighthouse is tried at each of its places, in all maps with at most ``TRIED_EDGES`` edges.
    """
    most = min(question.edges, TRIED_EDGES)
    for map_ in (map_ for edges in range(1, most + 1) for map_ in rooted_maps(edges)):
        for placed in question.kind.places(map_, 0):
            found, word = letters_at(placed, map_), question.words.get(map_.degree_at[0], ())
            marks = [p.marks for p in placed.percepts(map_) if p.marks or p.bearing is not None]
            turned = found in [word[k:] + word[:k] for k in range(len(word))]
            if not turned or 0 in marks or len(marks) > sum(map(bool, found)) or placed.told(map_):
                raise InputError(
                    f"lighthouse {show(question.lighthouse)} does not show marks at v0 alone, by "
                    f"the bearing and the degree, in {map_}; of others 'ambiguity census' makes "
                    "all small worlds"
                )


def question_of(request: SearchRequest) -> Question:
    """The question that a request asks.

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    name, own, options = str(request.lighthouse).partition(":")
    own = own if own and name not in kinds.LIGHTHOUSES and tried_kind(request.lighthouse) else ""
    lettered = name in LETTERS and "start=" not in options
    if request.lighthouse not in SEARCHED and not own and not lettered:
        more = (
            ", of which there are formulas; 'ambiguity census' takes every lighthouse, and makes "
            "all small worlds"
        )
        raise not_one_of("lighthouse", request.lighthouse, (*SEARCHED, *LETTERS), more)
    question = Question(
        request.lighthouse,
        request.map_class,
        request.vertices,
        request.edges,
        request.degree_marked,
        request.degree_others,
        tuple(_walk(request)),
    )
    for name, value in (("vertices", question.vertices), ("edges", question.edges)):
        if an_integer(name, value) < 1:
            raise InputError(f"{name} = {show(value)}, but a map has at least 1")
        at_most(name, value, LARGEST_SIZE)
    degrees = {"degree-marked": question.degree_marked, "degree-others": question.degree_others}
    for name, degree in degrees.items():
        if degree is not None and an_integer(name, degree) < 1:
            raise InputError(f"{name} = {show(degree)}, but every vertex has at least 1 dart")
    if own:
        _ensure_at_v0(question)
    if question.words and question.walk:
        raise InputError(f"there is no walk with --lighthouse {question.lighthouse}; leave it out")
    for step in question.walk:
        if step.present and not question.sensing.marks_v0:
            raise InputError(
                f"percept {step.percept} needs a marked vertex, but there is none with "
                f"--lighthouse {question.lighthouse}; legal is {step.degree}A"
            )
    return question


def _walk(request: SearchRequest) -> Iterator[Step]:
    """Yield the steps of the walk that a request asks for: a motion, and the percept after it.

    Raises:
        InputError: naming the value that is no motion or no percept.
    """
    motions, percepts = request.motions, request.percepts
    for name, values in (("motions", motions), ("percepts", percepts)):
        if not isinstance(values, Sequence) or isinstance(values, str):
            raise InputError(f"{name} = {show(values)} is not a list")
    if len(motions) != len(percepts):
        raise InputError(
            f"{len(motions)} motions and {len(percepts)} percepts, but there is one percept after "
            "each motion"
        )
    for motion, percept in zip(motions, percepts, strict=True):
        sensed = re.fullmatch(r"([1-9][0-9]{0,8})([AP])", a_text("percept", percept))
        if sensed is None:
            raise InputError(
                f"percept {show(percept)} is not of the form 3A (marker absent) or 4P (present)"
            )
        yield Step(an_integer("motion", motion), int(sensed[1]), sensed[2] == "P")
