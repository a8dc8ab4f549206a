"""Conditions of users', and every world of a class."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from random import Random
from typing import Annotated, ClassVar, Literal, TypeAlias

from msgspec import Struct

from allworlds.document.struct import IfAny, Text, about
from allworlds.inputs.checks import InputError, a_text, show
from allworlds.inputs.requests import RARE_SCOPE, Option, Request, Taken
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
from allworlds.maps.enumeration import Gluing, rooted_maps
from allworlds.protocol.importing import attempted
from allworlds.protocol.user_code import LocalCode, Role, UserCode
from allworlds.world.asked_lighthouse import tried_kind
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.kinds import GivenLighthouse
from allworlds.world.world import World

PREDICATE = Role(
    "where",
    "allworlds.predicates",
    "def predicate(map), which returns True or False",
    (LEGAL,),
)

TRIED_EDGES = 3
"""In all maps with so many edges a predicate must not depend on the numbering of the darts."""

Predicate: TypeAlias = Callable[[CombinatorialMap], bool]


class OwnCondition(Struct, frozen=True):
    """A predicate of the user's; it is loaded where maps are made.

    Its function may have an attribute ``begins``: a function of a partial gluing that says whether
    a map of which the predicate is true may begin so.
    """

    code: UserCode | LocalCode
    dual: ClassVar[bool] = False

    @property
    def name(self) -> str:
        """As ``--where`` takes it."""
        return self.code.name

    @property
    def codes(self) -> tuple[UserCode, ...]:
        """The predicate, if other processes can load it."""
        return (self.code,) if isinstance(self.code, UserCode) else ()

    def holds(self, map_: CombinatorialMap) -> bool:
        """Whether the predicate says so.

        Raises:
            InputError: if it raises, or says neither True nor False.
        """
        return self._decided("", self.code(map_))

    @property
    def narrows(self) -> bool:
        """Whether the function has ``begins``."""
        return hasattr(self.code.function, "begins")

    def may_begin(self, gluing: Gluing) -> bool:
        """Whether a map of which the predicate is true may begin so, as ``begins`` says.

        Raises:
            InputError: as :meth:`holds`.
        """
        begins = self.code.function.begins
        what = f"begins of where {show(self.name)} raises"
        return self._decided("begins of ", attempted(what, lambda: begins(gluing)))

    def _decided(self, part: str, found: object) -> bool:
        if type(found) is not bool:
            raise InputError(
                f"{part}where {show(self.name)} returns {show(found)}, not True or False"
            )
        return found

    def __str__(self) -> str:
        return self.name


def a_condition(given: object, *, local: bool = False) -> Condition | None:
    """The condition of a name or function, or all of several; the user's are tried on small maps.

    Args:
        given: names, functions, or conditions.
        local: whether it is used in this process alone, so that any function will do.

    Raises:
        InputError: naming the legal ones, or two numberings of one map that it takes apart.
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
    """The condition itself, unless it was recorded, and so tried before.

    Raises:
        InputError: if it is no function of the map, or if ``begins`` cuts off a map that it is
            true of.
    """
    if own.codes and own.codes[0].recorded:
        return own
    names = Random(TRIED_EDGES)  # noqa: S311  # any names
    for edges in range(1, TRIED_EDGES + 1):
        begun = {*rooted_maps(edges, where=own)}
        for map_ in rooted_maps(edges):
            says = own.holds(map_)
            if own.holds(map_) != says:
                raise InputError(
                    f"where {show(own.name)} is no function of the map: asked twice, it says "
                    f"{says} and {not says} of {map_}"
                )
            other = [*map_.darts]
            names.shuffle(other)
            renamed = map_.relabelled(other)
            if own.holds(renamed) != says:
                raise InputError(
                    f"where {show(own.name)} depends on the numbering of the darts: it says "
                    f"{says} of {map_}, and {not says} of the same map as {renamed}"
                )
            if says and map_ not in begun:
                raise InputError(
                    f"where {show(own.name)} is true of {map_}, and its begins says that no such "
                    "map begins as this one does"
                )
    return own


class WhereOptions(Request):
    """The part of a request that adds a condition on the maps."""

    where: Annotated[
        Taken[
            str | Predicate | Condition | Sequence[str | Predicate | Condition] | None,
            Condition | None,
        ],
        Option(
            RARE_SCOPE,
            "WHERE",
            f"Only maps of which that is true: {LEGAL}, or path/to/file.py:predicate, a function "
            "of a map. Of several, each is true: repeat the option.",
            repeated=True,
            told=Annotated[IfAny[Text | None], about("what besides is true of the maps")],
        ),
    ] = Taken(a_condition, None)

    @property
    def condition(self) -> Condition | None:
        """The condition, for the extent."""
        return self.where


def files_of_condition(condition: Condition | None) -> tuple[Path, ...]:
    """The files of the user's that a condition needs."""
    return tuple(file for code in getattr(condition, "codes", ()) for file in code.files)


def worlds(
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = "maps",
    lighthouse: GivenLighthouse = "directional",
    places: Literal["all", "first"] = "first",
    where: str | Predicate | Condition | None = None,
) -> Iterator[World]:
    """Every world of a class, in the fixed order.

    Args:
        edges: the largest number of edges (default: one that takes seconds).
        vertices: the largest number of vertices.
        map_class: one of :class:`~allworlds.maps.classes.MapClass`.
        lighthouse: the kind of lighthouse.
        places: ``first``: one world a rooted map, as reports count worlds; ``all``: one for
            every place of the lighthouse, as reports count runs.
        where: what besides is true of the maps, as ``--where`` takes it, or any function of a map.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if edges is None and vertices is None:
        edges = DEFAULT_EDGES
    extent = Extent(MapClass.named(map_class), edges, vertices, a_condition(where, local=True))
    kind = tried_kind(lighthouse).as_class
    if places not in ("all", "first"):
        raise InputError(f"places {show(places)} is not one of all, first")
    return _worlds(extent, kind, places)


def _worlds(extent: Extent, kind: type[Lighthouse], places: str) -> Iterator[World]:
    for level in extent.levels:
        bounds = (level, extent.map_class, extent.vertices)
        for map_ in rooted_maps(*bounds, where=extent.where):
            for placed in kind.places(map_, 0):
                yield World(map_, placed, 0)
                if places == "first":
                    break
