"""Worlds: a map, a lighthouse and a start; explorers never see one."""

from allworlds.world.lighthouses import (
    LIGHTHOUSES,
    Cluster,
    Compass,
    Directional,
    InvalidWorld,
    Lighthouse,
    Natural,
    Nothing,
    Position,
    lighthouse_from_json,
    lighthouse_named,
)
from allworlds.world.lighthouses.sensing import Sensing, Where
from allworlds.world.world import IllegalAction, World

__all__ = [
    "LIGHTHOUSES",
    "Cluster",
    "Compass",
    "Directional",
    "IllegalAction",
    "InvalidWorld",
    "Lighthouse",
    "Natural",
    "Nothing",
    "Position",
    "Sensing",
    "Where",
    "World",
    "lighthouse_from_json",
    "lighthouse_named",
]
