"""No lighthouse at all."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from allworlds.world.lighthouses.base import PlacelessLighthouse


@dataclass(frozen=True, slots=True)
class Nothing(PlacelessLighthouse):
    """No marker and no direction: only the degree is sensed.

    Source: Section III of the paper ('lacking any position and orientation information').
    """

    kind: ClassVar[str] = "none"
