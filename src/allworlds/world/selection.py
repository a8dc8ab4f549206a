"""The selection of worlds: a condition on the maps, and the kind of lighthouse.

A condition or a kind may be a user's program; the program is tried in small maps before it is used.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import islice
from pathlib import Path
from random import Random
from typing import Annotated, Literal, TypeAlias

from msgspec import Struct

from allworlds.documents.document import IfAny, Text, about
from allworlds.inputs.checks import InputError, a_text, not_one_of, one_of, show
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Converted, Option, Request
from allworlds.maps.classes import (
    AND,
    DEFAULT_EDGES,
    LEGAL,
    AllOf,
    Condition,
    Extent,
    MapClass,
    condition_named,
)
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.enumeration import rooted_maps
from allworlds.protocol.user_code import LocalCode, Role, UserCode
from allworlds.world.lighthouses import base, options
from allworlds.world.lighthouses.kinds import (
    LIGHTHOUSES,
    OWN,
    GivenLighthouse,
    LighthouseKind,
    lighthouse_kind,
)
from allworlds.world.world import World

TRIED_EDGES = 3
"""The number of edges up to which a user's code is tried in all maps."""


def _renamed(edges: int) -> Iterator[tuple[CombinatorialMap, Sequence[int]]]:
    """Yield all maps with at most this number of edges, each with random new names of its darts."""
    names = Random(edges)  # noqa: S311  # any names
    for level in range(1, edges + 1):
        for map_ in rooted_maps(level):
            other = [*map_.darts]
            names.shuffle(other)
            yield map_, other


# ---------------------------------------------------------------- conditions on maps


PREDICATE = Role(
    "where",
    "allworlds.predicates",
    "def predicate(map), which returns True or False",
    tuple(LEGAL.split(", ")),
)

Predicate: TypeAlias = Callable[[CombinatorialMap], bool]


class OwnCondition(Struct, frozen=True):
    """A condition on maps for which a user has written a predicate.

    Each process that makes maps loads the user's program.
    """

    code: UserCode | LocalCode

    @property
    def name(self) -> str:
        """The name that ``--where`` takes."""
        return self.code.name

    @property
    def codes(self) -> tuple[UserCode, ...]:
        """The program with the predicate as a tuple; empty if other processes cannot load it."""
        return (self.code,) if isinstance(self.code, UserCode) else ()

    def holds(self, map_: CombinatorialMap) -> bool:
        """Whether the predicate is true of a map.

        Raises:
            InputError: if the predicate raises, or returns no boolean.
        """
        found: object = self.code(map_)
        if type(found) is not bool:
            raise InputError(f"where {show(self.name)} returns {show(found)}, not True or False")
        return found

    def __str__(self) -> str:
        return self.name


def a_condition(given: object, *, local: bool = False) -> Condition | None:
    """The condition that a name or a function means; of several, that all of them are true.

    A user's function is tried on small maps first.

    Args:
        given: a name, a function or a condition, or a list of these; or a text of several names
            with ``and`` between.  None for no condition.
        local: whether only this process uses the condition.  Then any function is legal; otherwise
            a function must be one that other processes can import.

    Raises:
        InputError: naming the legal conditions, or a map about which the function says both True
            and False: in two calls, or after the darts are renamed.
    """
    if given is None:
        return None
    several = given.split(AND) if isinstance(given, str) else given
    if not isinstance(several, list | tuple):
        return _one_condition(given, local=local)
    parts = tuple(dict.fromkeys(_one_condition(each, local=local) for each in several))
    return AllOf(parts) if len(parts) > 1 else next(iter(parts), None)


def _one_condition(given: object, *, local: bool) -> Condition:
    if isinstance(getattr(given, "name", None), str) and hasattr(given, "holds"):
        return given  # type: ignore[return-value]  # it has what conditions have
    if isinstance(given, str) and (ours := condition_named(given)) is not None:
        return ours
    if not callable(given):
        code: UserCode | LocalCode = PREDICATE.find(a_text("where", given))
    else:
        code = LocalCode(PREDICATE, given) if local else PREDICATE.of(given)
    return _tried(OwnCondition(code))


def _tried(own: OwnCondition) -> OwnCondition:
    """Try the predicate of a condition on small maps, and return the condition.

    If the text of the predicate was recorded, in a report or a run directory, there is no trial,
    since the predicate was tried before its text was recorded.

    Raises:
        InputError: if the predicate says different things about the same map.
    """
    if own.codes and own.codes[0].recorded:
        return own
    for map_, other in _renamed(TRIED_EDGES):
        renamed = map_.relabelled(other)
        says = [own.holds(each) for each in (map_, map_, renamed)]
        if len({*says}) > 1:
            raise InputError(
                f"where {show(own.name)} is no function of the map: asked twice about {map_}, and "
                f"about the same map as {renamed}, it says {says}"
            )
    return own


def files_of_condition(condition: Condition | None) -> tuple[Path, ...]:
    """The user's files that a condition needs; the result is empty for None."""
    return tuple(file for code in getattr(condition, "codes", ()) for file in code.files)


# ---------------------------------------------------------------- kinds of lighthouses


def tried_kind(given: object) -> LighthouseKind:
    """The kind of lighthouse that a name or a class means; a user's kind is tried in small maps.

    Raises:
        InvalidWorld: naming the legal kinds, or a small map with a fault that :func:`flaws_of`
            finds.
    """
    kind = lighthouse_kind(given)
    if any(not code.recorded for code in kind.codes):
        _try(kind)
    return kind


@cache
def _try(kind: LighthouseKind) -> None:
    for wrong in flaws_of(kind, TRIED_EDGES):
        raise options.InvalidWorld(wrong)


def flaws_of(kind: LighthouseKind, edges: int) -> Iterator[str]:
    """Yield faults of a kind of lighthouse in maps with at most ``edges`` edges.

    At most one fault is yielded for each map.  The following rules are tested.  The kind has a
    place in at least one map with at most ``edges + 1`` edges.  No place occurs twice.  Two calls
    of a method return the same.  If the darts get other names, the places, their order, the
    percepts, and the value told to the explorer stay the same.  The kind gives marks and bearings
    only if its class says so.  If a lighthouse is written as JSON and read again, the result is an
    equal lighthouse.
    """
    for map_, other in _renamed(edges):
        for wrong in islice(_flaws(kind.as_class, map_, other), 1):
            yield f"the lighthouse {kind} in {map_}: {wrong}"
    maps = (map_ for level in range(1, edges + 2) for map_ in rooted_maps(level))
    if not any(True for map_ in maps for _ in kind.as_class.places(map_, 0)):
        yield f"the lighthouse {kind} has no place in any map with at most {edges + 1} edges"


def _flaws(
    kind: type[base.Lighthouse], map_: CombinatorialMap, other: Sequence[int]
) -> Iterator[str]:
    places = [*kind.places(map_, 0)]
    for number, placed in enumerate(places):
        if placed in places[:number]:
            yield f"the place {placed} is there twice"
    if places != [*kind.places(map_, 0)]:
        yield "asked twice, it has other places"
    renamed = [*kind.places(map_.relabelled(other), other[0])]
    legal = [placed.relabelled(other) for placed in places]
    if renamed != legal:
        said = f"with the darts renamed to {[*other]}, it has the places {renamed}"
        yield f"{said}; legal are {legal} in this order, found from the start and by no name"
    for placed in places:
        yield from _flaws_at(World(map_, placed), other)


def _flaws_at(world: World, other: Sequence[int]) -> Iterator[str]:
    placed, sensed, renamed = world.lighthouse, world.percepts, world.relabelled(other)
    named = f"with the darts renamed to {[*other]}"
    if sensed != placed.percepts(world.map):
        yield f"asked twice, {placed} senses something else"
    for dart in world.map.darts:
        if (there := renamed.percepts[other[dart]]) != sensed[dart]:
            yield f"{placed} senses '{sensed[dart]}' at dart {dart}, and '{there}' {named}"
    answers = [world.told, world.told, renamed.told]
    if answers.count(answers[0]) < len(answers):
        yield f"{placed} tells {answers[0]}, asked again {answers[1]}, and {answers[2]} {named}"
    if not placed.as_kind.gives_marks and any(percept.marks for percept in sensed):
        yield f"{placed} gives marks, but gives_marks is False"
    if not placed.as_kind.gives_bearings and any(percept.bearing is not None for percept in sensed):
        yield f"{placed} gives bearings, but gives_bearings is False"
    if World.from_json(world.to_json()) != world:
        yield f"{placed} is read otherwise than it is written"


# ---------------------------------------------------------------- every world


def worlds(
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = "maps",
    lighthouse: GivenLighthouse = "directional",
    places: Literal["all", "first"] = "first",
    where: str | Predicate | Condition | None = None,
) -> Iterator[World]:
    """Yield all worlds of a class, in a fixed order.

    A rooted map in which the lighthouse has no place makes no world.

    Args:
        edges: the largest number of edges.  If neither bound is given, it is 5.  If only a bound on
            the vertices is given, the class must be ``simple`` or ``planar-simple``.
        vertices: the largest number of vertices; None for no bound.
        map_class: the name of a class of maps, such as ``simple``.
        lighthouse: the kind of lighthouse.
        places: ``first``: only the first place of the lighthouse in each rooted map; ``all``: every
            place.
        where: a condition on the maps: a name as on the command line, or a function that gets a map
            and returns whether the map meets the condition.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if edges is None and vertices is None:
        edges = DEFAULT_EDGES
    extent = Extent(MapClass.named(map_class), edges, vertices, a_condition(where, local=True))
    kind = tried_kind(lighthouse).as_class
    if places not in ("all", "first"):
        raise not_one_of("places", places, ("all", "first"))
    return _worlds(extent, kind, places)


def _worlds(extent: Extent, kind: type[base.Lighthouse], places: str) -> Iterator[World]:
    for level in extent.levels:
        bounds = (level, extent.map_class, extent.vertices)
        for map_ in rooted_maps(*bounds, where=extent.where):
            every = kind.places(map_, 0)
            for placed in every if places == "all" else islice(every, 1):
                yield World(map_, placed, 0)


# ---------------------------------------------------------------- options


class WhereOptions(Request):
    """The part of a request that adds a condition on the maps."""

    where: Annotated[
        Converted[
            str | Predicate | Condition | Sequence[str | Predicate | Condition] | None,
            Condition | None,
        ],
        Option(
            RARE_SCOPE,
            "WHERE",
            f"Only maps of which that is true: {LEGAL}, or path/to/file.py:predicate, a function "
            "of a map. Of several, each is true: repeat the option.",
            repeated=True,
            document_type=Annotated[IfAny[Text | None], about("what besides is true of the maps")],
        ),
    ] = Converted(a_condition, None)

    @property
    def condition(self) -> Condition | None:
        """The condition on the maps; None without a condition."""
        return self.where


def kind_if_any(given: object) -> LighthouseKind | None:
    """The kind of lighthouse that :func:`tried_kind` returns for ``given``; None for None."""
    return None if given is None else tried_kind(given)


class LighthouseOptions(Request):
    """The part of a request that names the kind of lighthouse."""

    lighthouse: Annotated[
        Converted[GivenLighthouse | None, LighthouseKind | None],
        Option(
            SCOPE,
            "KIND",
            f"KIND[:key=value,...]: {one_of(LIGHTHOUSES)}, {OWN}, or several with + between them; "
            "compass: port numbers, doormarks: writing on doors [default: directional, or the one "
            "that a built-in explorer is written for].",
            document_type=Annotated[Text, about("`KIND[:key=value,...]`")],
        ),
    ] = Converted(kind_if_any, None)
