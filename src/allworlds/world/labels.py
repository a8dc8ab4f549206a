"""The labels of a world: its name, and the names and positions of its vertices."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from msgspec import Struct

from allworlds.maps.combinatorial import CombinatorialMap, Dart, Vertex

Position: TypeAlias = tuple[float, float]
"""Two coordinates: to the right, and up."""


class Labels(Struct, frozen=True):
    """What a user calls a world and its vertices; nothing of it is sensed, or decides anything.

    Attributes:
        name: of the world, in its file; empty if it has none.
        vertices: their names, in the order of ``map.vertices``; empty if they have none.
        positions: where each vertex is drawn; empty if that is not known.
    """

    name: str = ""
    vertices: tuple[str, ...] = ()
    positions: tuple[Position, ...] = ()

    def vertex(self, vertex: Vertex) -> str:
        """The name of a vertex; ``v3`` if it has none."""
        return self.vertices[vertex] if self.vertices else f"v{vertex}"

    def relabelled(
        self, map_: CombinatorialMap, names: Sequence[Dart], other: CombinatorialMap
    ) -> Labels:
        """The labels of the other map, in which dart ``d`` of the map is ``names[d]``."""
        old = [0] * other.vertex_count
        for vertex, darts in enumerate(map_.vertices):
            old[other.vertex_of[names[darts[0]]]] = vertex
        return Labels(
            self.name,
            tuple(self.vertices[v] for v in old) if self.vertices else (),
            tuple(self.positions[v] for v in old) if self.positions else (),
        )

    def mirrored(self) -> Labels:
        """The labels of the mirror image: left becomes right."""
        return Labels(self.name, self.vertices, tuple((-x, y) for x, y in self.positions))


PLAIN = Labels()
"""No labels."""
