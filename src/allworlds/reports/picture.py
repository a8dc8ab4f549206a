"""A world and an answer as every text draws them."""

from __future__ import annotations

from allworlds.drawing import draw
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.world import Directional, World


def world_picture(world: World, robot: Dart, width: int) -> str:
    """The world with its start, its marker, and the robot at the end of its walk."""
    lighthouse = world.lighthouse
    pointed = lighthouse.dart if isinstance(lighthouse, Directional) else None
    labels = ["R" if dart == robot else "" for dart in world.map.darts]
    text = draw(world.map, start=world.start, pointed=pointed, labels=labels, width=width)
    return text + "   R robot at the end"


def answer_picture(map_: CombinatorialMap, here: Dart, width: int) -> str:
    """The estimated map, from the dart where the robot believes to be."""
    labels = ["R" if dart == here else "" for dart in map_.darts]
    return draw(map_, start=here, labels=labels, width=width)
