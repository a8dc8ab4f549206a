"""Lighthouses without a marker: what is told, or nothing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal, TypeAlias

from allworlds.document.struct import Different, about, narrowed
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.world.lighthouses.base import PlacelessLighthouse


@dataclass(frozen=True, slots=True)
class Nothing(PlacelessLighthouse):
    """No marker and no direction: only the degree is sensed.

    Source: Section III of the paper ('lacking any position and orientation information').
    """

    kind: ClassVar[str] = "none"


ToldName: TypeAlias = Literal["n", "m", "d", "g"]

TOLD: dict[ToldName, Callable[[CombinatorialMap], int]] = {
    "n": lambda map_: map_.vertex_count,
    "m": lambda map_: map_.edge_count,
    "d": lambda map_: map_.diameter,
    "g": lambda map_: map_.genus,
}
"""The numbers that can be told, by their names: of vertices, of edges, the diameter, the genus."""


@dataclass(frozen=True, slots=True)
class Knowledge(PlacelessLighthouse):
    """A lighthouse without marks: the robot is told some numbers of the world.

    Sensed: the degree alone.  ``told`` holds the numbers by their names: n (vertices), m (edges),
    d (diameter), g (genus); n and m where none is named.
    """

    names: Annotated[
        Different[ToldName], narrowed(minItems=1), about("of the numbers: n, m, d, g")
    ] = ("n", "m")

    kind: ClassVar[str] = "told"

    def told(self, map_: CombinatorialMap) -> dict[str, int]:
        """The numbers by their names."""
        return {name: TOLD[name](map_) for name in self.names}
