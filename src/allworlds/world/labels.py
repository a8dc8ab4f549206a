"""The labels of a world: its name, and the names and positions of its vertices."""

from collections.abc import Sequence
from typing import TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import show
from allworlds.maps.combinatorial import CombinatorialMap, Dart, Vertex
from allworlds.world.lighthouses.options import InvalidWorld

Position: TypeAlias = tuple[float, float]
"""Two coordinates: to the right, and up."""

FARTHEST = 1e300
"""No coordinate is larger, so that differences are finite."""


class Labelling(Struct, frozen=True):
    """Names of a world and of its vertices; nothing of it is sensed, or decides anything.

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

    def checked(self, map_: CombinatorialMap) -> "Labelling":
        """These labels, in tuples.

        Raises:
            InvalidWorld: naming a label that is none, and what would be legal.
        """
        if not isinstance(self.name, str) or not self.name.isprintable():
            raise InvalidWorld(f"name = {show(self.name)} is no printable text")
        many = map_.vertex_count
        for key, labels in (("names", self.vertices), ("positions", self.positions)):
            if not isinstance(labels, list | tuple) or len(labels) not in (0, many):
                raise InvalidWorld(
                    f"{key} = {show(labels)} is no list of {many}, one for each vertex of the map"
                )
        first: dict[str, Vertex] = {}
        for vertex, name in enumerate(self.vertices):
            if not isinstance(name, str) or not name.strip() or not name.isprintable():
                raise InvalidWorld(f"names[{vertex}] = {show(name)} is no printable text")
            if first.setdefault(name, vertex) != vertex:
                raise InvalidWorld(
                    f"names[{vertex}] = {show(name)} is names[{first[name]}], too; names differ"
                )
        places = tuple(_a_position(v, place) for v, place in enumerate(self.positions))
        return Labelling(self.name, tuple(self.vertices), places)

    def relabelled(
        self, map_: CombinatorialMap, names: Sequence[Dart], other: CombinatorialMap
    ) -> "Labelling":
        """The labels of the other map, in which dart ``d`` of the map is ``names[d]``."""
        old = [0] * other.vertex_count
        for vertex, darts in enumerate(map_.vertices):
            old[other.vertex_of[names[darts[0]]]] = vertex
        return Labelling(
            self.name,
            tuple(self.vertices[v] for v in old) if self.vertices else (),
            tuple(self.positions[v] for v in old) if self.positions else (),
        )

    def mirrored(self) -> "Labelling":
        """The labels of the mirror image: left becomes right."""
        return Labelling(self.name, self.vertices, tuple((-x, y) for x, y in self.positions))


PLAIN = Labelling()
"""No labels."""


def _a_position(vertex: Vertex, given: object) -> Position:
    """The position; raise InvalidWorld unless it is a pair of finite numbers."""
    match given:
        case [int() | float() as x, int() | float() as y]:
            if all(-FARTHEST <= value <= FARTHEST for value in (x, y)):
                return float(x), float(y)
    raise InvalidWorld(f"positions[{vertex}] = {show(given)} is no pair of finite numbers")
