"""Worlds that look alike: the comparison of two worlds, and all members of an ambiguity class.

A bisimulation proves that no motion tells two worlds apart; a walk proves that motions tell them
apart.  The members of an ambiguity class are the maps that have the quotient of the class; the name
of a member is its code.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import KW_ONLY
from itertools import permutations
from typing import Annotated, Any, Literal, NamedTuple, Self, TypeAlias

from msgspec import UNSET, UnsetType

from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.inputs.checks import InputError, an_integer, integer_of, show
from allworlds.inputs.requests import EFFORT, Argument, Option, Request, answers
from allworlds.maps.classes import ClassOptions, MapClass
from allworlds.maps.combinatorial import Code, CombinatorialMap, Dart, rooted_code
from allworlds.maps.quotient import (
    Projection,
    Quotient,
    class_size,
    classes_of_union,
    is_ambiguous,
    pose_count,
    project,
)
from allworlds.outcome import Disagreement
from allworlds.protocol.actions import Percept
from allworlds.studies.options import ListenerOptions
from allworlds.world.bisimulation import flaw, same_world_from, sensed
from allworlds.world.lighthouses.kinds import (
    LIGHTHOUSES,
    GivenLighthouse,
    LighthouseKind,
    kind_of,
)
from allworlds.world.lighthouses.marked import Directional, Position
from allworlds.world.named import LIGHTHOUSE, WORLD, world_named
from allworlds.world.world import World


class TwinsRequest(Request, kw_only=False):
    """Request of ``ambiguity twins``: the two worlds."""

    a: Annotated[World | str, Argument("", "A", WORLD.help)]
    b: Annotated[World | str, Argument("", "B", "Another one.")]
    _: KW_ONLY
    lighthouse: Annotated[GivenLighthouse, LIGHTHOUSE] = Position.kind


Relation: TypeAlias = Literal["same", "same-map", "different"]
"""The relation of two worlds.

``same``: the worlds are isomorphic; ``same-map``: the worlds are one map with its lighthouse,
entered at two darts; ``different``: the maps differ, or the places of the lighthouses.
"""


class ComparedWorlds(Report):
    """Report of 'twins'.

    Two worlds: whether they are the same, one map entered at two darts, or different; and the proof
    that motions tell them apart, or that no motions do.
    """

    worlds: Annotated[doc.Pair[World], doc.about("the two, as they were understood")]
    relation: Annotated[
        Relation,
        doc.about("`same`: one world; `same-map`: one world entered at two darts; `different`"),
    ]
    motions: Annotated[
        tuple[doc.Natural, ...] | UnsetType,
        doc.about("if distinguishable: the shortest motions that tell them apart"),
    ] = UNSET
    percepts: Annotated[
        doc.Pair[doc.Some[Percept]] | UnsetType,
        doc.about(
            "with the motions: for each world the percepts at the start and after each of them"
        ),
    ] = UNSET
    told: Annotated[
        doc.Pair[int | dict[str, int] | None] | UnsetType,
        doc.about("if that is different: what is told in each world before the start"),
    ] = UNSET
    bisimulation: Annotated[
        doc.Pair[Annotated[tuple[doc.Natural, ...], doc.narrowed(minItems=2)]] | UnsetType,
        doc.about("if not: for each world the class of each dart"),
    ] = UNSET

    @doc.computed
    def distinguishable(self) -> bool:
        """Whether a robot can tell the worlds apart, by motions or by a value told at the start.

        Some lighthouses tell the robot a value before the start, for example the degree of v1.
        """
        return self.bisimulation is UNSET

    @doc.computed
    def twins(self) -> bool:
        """Whether the two worlds are different, and a robot cannot tell them apart."""
        return self.relation == "different" and not self.distinguishable


@answers(TwinsRequest)
def twins(request: TwinsRequest) -> ComparedWorlds:
    """Decide whether a robot can tell two worlds apart, and return a checked proof.

    A robot can tell them apart if the percepts after some motions differ, or if its lighthouse
    tells it different values before the start.

    Raises:
        InputError: if the lighthouses are of different kinds, whose percepts are not comparable.

    Cost: O(m log m) if no motion tells them apart; else a step for each visited pair of darts.
    """
    a, b = (world_named(world, request.lighthouse) for world in (request.a, request.b))
    kinds = [world.lighthouse.kind for world in (a, b)]
    if kinds[0] != kinds[1]:
        raise InputError(
            f"the worlds have the lighthouses {kinds[0]} and {kinds[1]}; two worlds are compared "
            "under one lighthouse"
        )
    ensure_motions_decide(kind_of(a.lighthouse), "twins are compared by motions alone")
    first, second = classes_of_union(*((w.map, w.percepts, w.start) for w in (a, b)))
    proof: dict[str, Any]
    if a.told != b.told:
        proof = {"motions": (), "percepts": ((a.first,), (b.first,)), "told": (a.told, b.told)}
        wrong = None
    elif first[a.start] == second[b.start]:
        proof = {"bisimulation": (first, second)}
        wrong = flaw((a, b), (first, second))
    else:
        motions = separation(a, b)
        proof = {"motions": motions, "percepts": (sensed(a, motions), sensed(b, motions))}
        wrong = replayed(a, b, motions)
    if wrong:
        raise Disagreement(f"the proof about {a} and {b} is wrong: {wrong}")
    start = None if a.told != b.told else same_world_from(a, b)
    relation: Relation = "different" if start is None else "same-map"
    return ComparedWorlds(worlds=(a, b), relation="same" if start == b.start else relation, **proof)


def separation(a: World, b: World) -> tuple[int, ...]:
    """The shortest sequence of motions after which the percepts in the two worlds differ.

    Of several shortest sequences it is the first in lexicographic order.  The search is
    breadth-first over pairs of darts, one dart of each world.

    Raises:
        Disagreement: if there is no such sequence; the caller must know that there is one.
    """
    seen = {(a.start, b.start)}
    # Two darts, and the motion that led there from the darts of an earlier entry.
    queue = [(a.start, b.start, 0, 0)]
    for number, (x, y, _, _) in enumerate(queue):
        if a.percepts[x] != b.percepts[y]:
            motions, at = list[int](), number
            while at:
                _, _, at, k = queue[at]
                motions.insert(0, k)
            return tuple(motions)
        for k in range(a.percepts[x].degree):
            reached = (a.map.move(x, k), b.map.move(y, k))
            if reached not in seen:
                seen.add(reached)
                queue.append((*reached, number, k))
    raise Disagreement(f"no motion tells {a} from {b}, but their quotients differ")


def replayed(a: World, b: World, motions: Sequence[int]) -> str | None:
    """The reason why these motions do not prove that two worlds can be told apart; None if they do.

    The motions are played in both worlds.  The percepts after the last motion must differ, and all
    percepts before must be equal; otherwise fewer motions would be enough.
    """
    one, other = sensed(a, motions), sensed(b, motions)
    if one[-1] == other[-1]:
        return "the last percepts are equal"
    return None if one[:-1] == other[:-1] else "a part of the motions is enough"


def ensure_motions_decide(kind: LighthouseKind, why: str) -> None:
    """Raise InputError, with the reason ``why``, if a robot can leave marks under this lighthouse.

    Then motions alone do not decide what the robot senses.
    """
    if kind.as_class.leaves_marks:
        standing = ", ".join(name for name, own in LIGHTHOUSES.items() if not own.leaves_marks)
        raise InputError(
            f"under the lighthouse {kind} the robot leaves marks itself, and {why}; legal are "
            f"{standing}"
        )


DEFAULT_LIMIT = 1000
"""The largest ambiguity class whose members are all listed by default."""


class ClassRequest(ListenerOptions, ClassOptions, kw_only=False):
    """Request of ``ambiguity class``: a world, and how many members are listed."""

    world: Annotated[World | str, WORLD]
    _: KW_ONLY
    limit: Annotated[
        int,
        Option(
            EFFORT,
            "L",
            "List at most L worlds; size and poses are exact all the same.",
            parse=integer_of,
        ),
    ] = DEFAULT_LIMIT
    lighthouse: Annotated[GivenLighthouse, LIGHTHOUSE] = Position.kind


class LeastRooting(NamedTuple):
    """The least code among some rootings of a map, and the number of rootings with this code."""

    code: Code
    times: int


def least_rooting(map_: CombinatorialMap, darts: Sequence[Dart]) -> LeastRooting:
    """The least code of a map with one marked vertex, rooted at one of ``darts``.

    ``darts`` are all darts of the marked vertex, or a class: those of its darts that look alike to
    a robot.  An isomorphism of two marked maps takes ``darts`` of the first map to ``darts`` of the
    second map.  So isomorphic marked maps have the same least code.

    Two rootings of a map have the same code exactly if an automorphism takes one root to the other.
    So the field ``times`` of the result is also the number of automorphisms that fix the marked
    vertex.

    Cost: O(m) for each dart.
    """
    codes = [rooted_code(map_.sigma, map_.alpha, dart) for dart in darts]
    least = min(codes)
    return LeastRooting(least, codes.count(least))


SheetPermutation: TypeAlias = tuple[int, ...]
"""A permutation of the sheets ``0..k-1``."""

_Kind: TypeAlias = Callable[[Sequence[SheetPermutation]], Iterator[SheetPermutation]]
"""One of several choices that are made in turn: a function that returns the options of its choice.

The argument of the function has the options that were chosen in the earlier choices.
"""


def lifts(quotient: Quotient) -> Iterator[CombinatorialMap]:
    """Yield the maps with this quotient, one for each way to connect the k sheets.

    A map with this quotient has k darts in each class, one in each of the k sheets.  The dart of
    class q in sheet i has the number ``q * k + i``.  If sigma takes class q to class p in the
    quotient, sigma of the map takes the k darts of q to the k darts of p.  A dart and its image are
    in the same sheet, unless a permutation of the sheets says that sheet i leads to another sheet.
    The same is true of alpha.  The permutations are chosen as follows; each combination of choices
    makes a map:

    - Each vertex of the quotient has a permutation.  It belongs to the vertex's last class, from
      which sigma leads back to the first class.  All cycles of the permutation have the vertex's
      cone index as their length.  Only at v0 there is no choice: sheet i leads to the next sheet,
      modulo k, because the sheets are numbered in the order of their darts round v0.
    - Each semi-edge, a class that alpha takes to itself, has a permutation.  All its cycles have
      length 2.
    - Each other edge outside a spanning tree of the quotient has a permutation, which can be any
      one.

    The same map with the same v0 is yielded several times: k / ``a`` times, if ``a`` automorphisms
    of the map fix v0.

    Cost: O(m) a map, and O(m) memory.
    """
    k, cycles = quotient.sheets, [*quotient.cone_indices[1:], *[2] * len(quotient.semi_edges)]

    def of_length(b: int) -> _Kind:
        return lambda _: uniform_permutations(k, b)

    kinds = [*map(of_length, cycles), *[lambda _: permutations(range(k))] * len(quotient.cotree)]
    for choice in _choices(kinds):
        yield _lift(quotient, iter(choice))


def _lift(quotient: Quotient, choice: Iterator[SheetPermutation]) -> CombinatorialMap:
    k = quotient.sheets
    sigma = [q * k + i for q in quotient.sigma for i in range(k)]
    alpha = [q * k + i for q in quotient.alpha for i in range(k)]
    first, *others = quotient.vertices
    _permute(sigma, k, first[-1], first[0], (*range(1, k), 0))
    for vertex in others:
        _permute(sigma, k, vertex[-1], vertex[0], next(choice))
    for q in quotient.semi_edges:
        _permute(alpha, k, q, q, next(choice))
    for q, other in quotient.cotree:
        moved = next(choice)
        _permute(alpha, k, q, other, moved)
        _permute(alpha, k, other, q, sorted(range(k), key=moved.__getitem__))
    return CombinatorialMap.trusted(sigma, alpha)


def _permute(map_: list[Dart], k: int, q: int, to: int, moved: Sequence[int]) -> None:
    """Set the images of the k darts of class ``q``: they are the k darts of class ``to``.

    The dart of class q in sheet i has the number ``q * k + i``.

    Args:
        map_: sigma or alpha of a map, which is changed.
        k: the number of sheets.
        q: the class of the darts.
        to: the class of their images.
        moved: entry i is the sheet of the image of the dart in sheet i.
    """
    map_[q * k : (q + 1) * k] = [to * k + i for i in moved]


def uniform_permutations(k: int, b: int) -> Iterator[SheetPermutation]:
    """Yield the permutations of ``0..k-1`` all of whose cycles have length b.

    There are none if b does not divide k.

    Cost: O(k) for each permutation at most.
    """
    if k % b:
        return
    if b == 1:
        yield tuple(range(k))
        return

    def next_cycle(cycles: Sequence[tuple[int, ...]]) -> Iterator[tuple[int, ...]]:
        used = {x for cycle in cycles for x in cycle}
        first, *free = (x for x in range(k) if x not in used)
        return ((first, *rest) for rest in permutations(free, b - 1))

    for cycles in _choices([next_cycle] * (k // b)):
        moved = [0] * k
        for cycle in cycles:
            for x, y in zip(cycle, (*cycle[1:], cycle[0]), strict=True):
                moved[x] = y
        yield tuple(moved)


def _choices(kinds: Sequence[_Kind]) -> Iterator[tuple[tuple[int, ...], ...]]:
    """Yield every combination with one option of each kind, in lexicographic order.

    A kind stands for one choice: it is a function that gets the options chosen for the earlier
    kinds, and returns its own options.

    ``itertools.product`` would store all options, and a recursion could not go through thousands of
    kinds; this function can, and stores no options.
    """
    chosen: list[SheetPermutation] = []
    options: list[Iterator[SheetPermutation]] = []
    while True:
        if len(chosen) == len(kinds):
            yield tuple(chosen)
        else:
            options.append(kinds[len(chosen)](chosen))
        while options:
            del chosen[len(options) - 1 :]
            if following := next(options[-1], None):
                chosen.append(following)
                break
            options.pop()
        else:
            return


class SensedQuotient(doc.Document):
    """A rooted quotient; its dart 0 is the class of the start."""

    sigma: Annotated[
        doc.Some[doc.Natural],
        doc.about("for each class of darts the next one clockwise"),
    ]
    alpha: Annotated[
        doc.Some[doc.Natural],
        doc.about("for each class the class at the other end; itself for a semi-edge"),
    ]
    degree: Annotated[doc.Some[doc.Positive], doc.about("the degree at each class")]
    marks: Annotated[
        doc.Some[doc.Natural],
        doc.about("the number of position markers at each class"),
    ]

    @classmethod
    def of(cls, quotient: Quotient) -> Self:
        """Return the document of a quotient.

        The label of each class must be the percept at its darts, as in :func:`projection_of`.
        """
        marks = tuple(label.marks for label in quotient.labels if isinstance(label, Percept))
        return cls(sigma=quotient.sigma, alpha=quotient.alpha, degree=quotient.degree, marks=marks)


class AmbiguityClass(Report):
    """Report of 'ambiguity class'.

    All worlds that no motion tells from a given world. The given world comes first, the other
    worlds are sorted by their codes. Each world is in canonical numbering, and starts at a dart
    that looks like the start of the given world. A pose is a world of the class with a dart where
    the robot can be; two darts count as one pose if an automorphism of the world takes one to the
    other.
    """

    world: Annotated[World, doc.about("as it was understood")]
    map_class: Annotated[MapClass, doc.about("the class of maps")] = doc.key(name="class")
    size: Annotated[doc.Positive, doc.about("the number of worlds in the ambiguity class")]
    poses: Annotated[
        doc.Positive,
        doc.about("how many pairs of a world and a dart where the robot can be"),
    ]
    sheets: Annotated[doc.Positive, doc.about("of the world as a cover of its quotient")]
    worlds: Annotated[
        doc.Some[World],
        doc.about("the given one first; each with start 0, where the robot could be"),
    ]
    quotient: Annotated[SensedQuotient, doc.about("what a robot can know")]

    @doc.computed
    def ambiguous(self) -> bool:
        """Whether the ambiguity class has another world than the given one."""
        return self.size > 1

    @doc.computed
    def listed(self) -> doc.Positive:
        """The number of listed worlds."""
        return len(self.worlds)

    @doc.computed
    def notice(self) -> doc.Text | None:
        """A remark that some worlds are not listed; null if all are listed."""
        return self.left_out

    @property
    def left_out(self) -> str | None:
        """A remark on the worlds that are not listed; None if all worlds are listed."""
        if self.listed == self.size:
            return None
        return (
            f"{self.listed} of {self.size} worlds are listed, as --limit says; "
            "size and poses are exact (Burnside's count)"
        )


def projection_of(world: World) -> Projection:
    """The quotient of a world, rooted at the class of the start, and the class of each dart.

    The quotient has a label for each class: the percept that a robot senses at the class's darts.
    """
    return project((world.map, world.percepts, world.start))


@answers(ClassRequest)
def class_of(request: ClassRequest) -> AmbiguityClass:
    """Find the complete ambiguity class of a world: all worlds that no motion tells from it.

    The lighthouse must be ``position`` or ``directional``; under ``directional`` the world is the
    only member.  The request also names a class of maps, such as ``planar``; a member counts only
    if its map is in this class of maps.

    Raises:
        InputError: for another lighthouse, under which an ambiguity class can be infinite; for a
            world whose map is outside the class of maps; for a limit below 1.  Also if the
            ambiguity class has more members than the limit, and the class of maps is not ``maps``:
            then not all members would be made, so those in the class of maps could not be counted.

    Cost: O(k m) for each of at most k * ``limit`` maps with the quotient; k is the number of
    sheets.
    """
    limit, universe = request.limit, request.map_class
    world = world_named(request.world, request.lighthouse)
    _checked(world, limit, universe)
    quotient, classes = projection_of(world)
    size = class_size(quotient)
    if (size > 1) != is_ambiguous(quotient):
        raise Disagreement(f"the criterion and Burnside's count {size} differ on {quotient}")
    if size > limit and universe is not MapClass.MAPS:
        raise InputError(
            f"limit {show(limit)} is too small: {size} worlds must be made to see which of them "
            f"are {universe}"
        )
    own = least_rooting(world.map, [d for d, q in enumerate(classes) if q == 0])
    found = _members(quotient, limit, own)
    poses = pose_count(quotient)
    if size <= limit:
        _check_complete(quotient, found, own)
        found = {
            code: rooting
            for code, rooting in found.items()
            if universe.includes(CombinatorialMap.trusted(*code))
        }
        size, poses = len(found), _poses(quotient, found)
    others = sorted(code for code in found if code != own.code)
    listed = tuple(_placed(world, code) for code in (own.code, *others))
    made = AmbiguityClass(
        world=world,
        map_class=universe,
        size=size,
        poses=poses,
        sheets=quotient.sheets,
        worlds=listed,
        quotient=SensedQuotient.of(quotient),
    )
    if made.notice:
        request.listener.notice(made.notice)
    return made


def _checked(world: World, limit: int, universe: MapClass) -> None:
    if world.lighthouse.written not in (Position.kind, Directional.kind):
        raise InputError(
            f"'ambiguity class' takes the lighthouses position and directional, not "
            f"{world.lighthouse.written}: a class may have no end where it is not known that one "
            "vertex looks like no other; see 'ambiguity census'"
        )
    if an_integer("limit", limit) < 1:
        raise InputError(f"limit {show(limit)} is too small; at least the world itself is listed")
    if not universe.includes(world.map):
        raise InputError(f"the world itself is not {universe}, so its class there is empty")


def _members(quotient: Quotient, limit: int, own: LeastRooting) -> dict[Code, LeastRooting]:
    """The members of an ambiguity class by their codes, at most ``limit`` of them.

    If the ambiguity class has at most ``limit`` members, all are returned.  Otherwise members are
    taken in the order in which :func:`lifts` yields them, each once.  If the given world, whose
    code is in ``own``, is one of the first ``limit`` members, these members are returned.  If not,
    the first ``limit - 1`` members are returned, and the caller can add the given world.
    """
    alike = range(quotient.sheets)  # the darts of a lift that lie over class 0
    found: dict[Code, LeastRooting] = {}
    for lift in lifts(quotient):
        rooting = least_rooting(lift, alike)
        # One place is kept for the given world until it is met.
        if len(found) < limit - (own.code not in found) or rooting.code == own.code:
            found[rooting.code] = rooting
        elif rooting.code not in found:
            break
    return found


def _check_complete(quotient: Quotient, found: dict[Code, LeastRooting], own: LeastRooting) -> None:
    """Raise Disagreement unless all members of the class have been found.

    Three things are checked: Burnside's lemma gives the same number of members, :func:`pose_count`
    gives the same number of poses, and the given world, whose code is in ``own``, is a member.
    """
    size, poses, weighed = class_size(quotient), pose_count(quotient), _poses(quotient, found)
    if len(found) != size or poses != weighed or own.code not in found:
        raise Disagreement(
            f"{len(found)} worlds have been made and {size} counted, with {weighed} and {poses} "
            f"poses, for the quotient {quotient}"
        )


def _poses(quotient: Quotient, found: dict[Code, LeastRooting]) -> int:
    """The number of poses: pairs of a world of the class and a dart in it, up to isomorphism.

    ``found`` has the worlds of the class.  The number is the sum of k / |Aut(world, v0)| over these
    worlds (the mass formula); k is the number of sheets, and Aut(world, v0) are the automorphisms
    that fix v0.
    """
    return sum(quotient.sheets // rooting.times for rooting in found.values())


def _placed(world: World, code: Code) -> World:
    """The member with this code, with the lighthouse of the given world."""
    map_ = CombinatorialMap.trusted(*code)
    if isinstance(world.lighthouse, Position):
        return World(map_, Position(0), 0)
    # A directional marker makes all darts different: the member is the world itself.
    assert world.first.bearing is not None
    return World(map_, Directional(map_.turn(0, world.first.bearing)), 0)
