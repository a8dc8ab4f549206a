"""A world and an answer as every text draws them."""

from __future__ import annotations

from allworlds.drawing import draw
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.world import Directional, World

LONGEST_ROW = 40
"""Of more vertices in a table, and of more darts of a vertex, both ends are shown."""


def world_picture(world: World, robot: Dart, width: int) -> str:
    """The world with its start, its marker, and the robot at the end of its walk."""
    lighthouse = world.lighthouse
    pointed = lighthouse.dart if isinstance(lighthouse, Directional) else None
    labels = ["R" if dart == robot else "" for dart in world.map.darts]
    text = draw(
        world.map,
        start=world.start,
        pointed=pointed,
        marked=markers(world),
        labels=labels,
        width=width,
        most=LONGEST_ROW,
    )
    return text + "   R robot at the end"


def markers(world: World) -> dict[int, int]:
    """For each vertex with markers that point nowhere their number."""
    if isinstance(world.lighthouse, Directional):
        return {}
    sensed = zip(world.map.vertex_of, world.percepts, strict=True)
    return {vertex: percept.marks for vertex, percept in sensed if percept.marks}


def answer_picture(map_: CombinatorialMap, here: Dart, width: int) -> str:
    """The estimated map, from the dart where the robot believes to be."""
    labels = ["R" if dart == here else "" for dart in map_.darts]
    return draw(map_, start=here, labels=labels, width=width, most=LONGEST_ROW)
