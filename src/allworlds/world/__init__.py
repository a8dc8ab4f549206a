"""Worlds: a map, a lighthouse and a start; explorers never see one."""

from allworlds.world.lighthouses import (
    LIGHTHOUSES,
    Directional,
    InvalidWorld,
    Lighthouse,
    lighthouse_from_json,
    lighthouse_named,
)
from allworlds.world.world import IllegalAction, World

__all__ = [
    "LIGHTHOUSES",
    "Directional",
    "IllegalAction",
    "InvalidWorld",
    "Lighthouse",
    "World",
    "lighthouse_from_json",
    "lighthouse_named",
]
