"""Worlds: a map, a lighthouse and a start; explorers never see one.

``lighthouses``
    what is marked, and what of it can be sensed; one kind a module;
``state``
    what a step changes: where the robot is, and where its markers are;
``world``
    the three together, and what a step does;
``named``
    what a WORLD may be on the command line and in Python.
"""

from allworlds.world.lighthouses import (
    LIGHTHOUSES,
    Cluster,
    Compass,
    Directional,
    InvalidWorld,
    Labels,
    Lighthouse,
    Movable,
    Natural,
    Nothing,
    Position,
    Sensing,
    WalkInAnswer,
    Where,
    lighthouse_from_json,
    lighthouse_named,
)
from allworlds.world.named import map_of_family, world_named, world_of_family
from allworlds.world.state import State
from allworlds.world.world import IllegalAction, World

__all__ = [
    "LIGHTHOUSES",
    "Cluster",
    "Compass",
    "Directional",
    "IllegalAction",
    "InvalidWorld",
    "Labels",
    "Lighthouse",
    "Movable",
    "Natural",
    "Nothing",
    "Position",
    "Sensing",
    "State",
    "WalkInAnswer",
    "Where",
    "World",
    "lighthouse_from_json",
    "lighthouse_named",
    "map_of_family",
    "world_named",
    "world_of_family",
]
