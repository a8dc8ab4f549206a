"""Worlds that the user gives to a check, in place of every world of a class."""

from __future__ import annotations

from collections.abc import Iterable

from allworlds.engines import WHOLE, Given
from allworlds.inputs import InputError, show
from allworlds.maps import Extent, numbering
from allworlds.studies.check.requests import CheckRequest
from allworlds.world import LighthouseKind, World, kind_of

EXCLUSIVE = ("edges", "vertices", "where", "lighthouse", "run", "corpus")
"""The options that name other worlds, or need worlds that another command can name."""


def given_worlds(worlds: Iterable[object], request: CheckRequest) -> tuple[Given, LighthouseKind]:
    """The worlds of a request as a check goes through them, and the lighthouse of all of them.

    Raises:
        InputError: if there are none, if one is no world, has another lighthouse or is not of the
            class, or if the request names worlds in another way, too.
    """
    for name in EXCLUSIVE:
        if getattr(request, name) is not None:
            given = show(str(getattr(request, name)))
            raise InputError(f"{name} = {given} cannot be given together with worlds")
    if request.shard != WHOLE:
        raise InputError(f"shard = {request.shard} cannot be given together with worlds")
    try:
        met = [*worlds]
    except TypeError:
        raise InputError(f"worlds = {show(worlds)} is no series of worlds") from None
    if not met:
        raise InputError("worlds = [] is empty; legal is one world or more")
    rooted = [_rooted(world, number, request) for number, world in enumerate(met)]
    kinds = [kind_of(world.lighthouse) for world in rooted]
    for number, kind in enumerate(kinds):
        if kind != kinds[0]:
            raise InputError(
                f"worlds[{number}] has the lighthouse {show(str(kind))}, and worlds[0] has "
                f"{show(str(kinds[0]))}; legal is one lighthouse for all"
            )
    placed = [(world, _place(world)) for world in rooted]
    return Given(tuple(sorted(placed, key=lambda each: each[0].map.edge_count))), kinds[0]


def extent_of(given: Given, request: CheckRequest) -> Extent:
    """The class of the request, as far as the largest of the given worlds."""
    return Extent(request.map_class, given.sizes[-1])


def _rooted(world: object, number: int, request: CheckRequest) -> World:
    """The world with its darts numbered from the start, which is dart 0."""
    if not isinstance(world, World):
        raise InputError(f"worlds[{number}] = {show(world)} is no World")
    map_ = world.map
    if not request.map_class.includes(map_):
        raise InputError(f"worlds[{number}] is not of the class {request.map_class}: {show(map_)}")
    names = [0] * len(map_.darts)
    for name, dart in enumerate(numbering(map_.sigma, map_.alpha, world.start)):
        names[dart] = name
    return world.relabelled(names)


def _place(world: World) -> int:
    """The number of the lighthouse's place among all that the map has; 0 of another one."""
    places = world.lighthouse.as_kind.places(world.map, 0)
    return next((i for i, place in enumerate(places) if place == world.lighthouse), 0)
