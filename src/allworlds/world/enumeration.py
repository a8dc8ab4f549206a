"""Every world of a class, for loops of one's own."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from allworlds.inputs import InputError, show
from allworlds.maps import DEFAULT_EDGES, Condition, Extent, MapClass, rooted_maps
from allworlds.world.asked_lighthouse import tried_kind
from allworlds.world.lighthouses.base import Lighthouse
from allworlds.world.lighthouses.kinds import GivenLighthouse
from allworlds.world.own_condition import Predicate, a_condition
from allworlds.world.world import World


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
