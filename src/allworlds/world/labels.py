"""The labels of a world: its name, and the names and positions of its vertices."""

from collections.abc import Mapping, Sequence
from typing import Annotated, Any, TypeAlias

from msgspec import Meta, Struct

from allworlds.documents.reading import parse
from allworlds.inputs.checks import InputError, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart, Vertex
from allworlds.world.lighthouses.options import InvalidWorld

FARTHEST = 1e300
"""The largest legal coordinate, so that differences of coordinates are finite."""

Coordinate: TypeAlias = Annotated[float, Meta(ge=-FARTHEST, le=FARTHEST)]

PlanePoint: TypeAlias = tuple[Coordinate, Coordinate]
"""The position of a vertex: two coordinates, to the right and up."""


class Labelling(Struct, frozen=True, rename={"vertices": "names"}):
    """The labels of a world: names and positions; no percept and no verdict depends on them.

    Attributes:
        name: the name of the world in its file; may be empty.
        vertices: the names of the vertices, in the order of ``map.vertices``; may be empty.
        positions: the position of each vertex in a drawing; empty if unknown.
    """

    name: str = ""
    vertices: tuple[str, ...] = ()
    positions: tuple[PlanePoint, ...] = ()

    def vertex(self, vertex: Vertex) -> str:
        """The name of a vertex; ``v3`` for vertex 3 if the vertices have no names."""
        return self.vertices[vertex] if self.vertices else f"v{vertex}"

    def checked(self, map_: CombinatorialMap) -> "Labelling":
        """These labels, as tuples, after a check that they fit the map.

        Raises:
            InvalidWorld: naming an illegal label, and what would be legal.
        """
        try:
            labels = parse(
                {"name": self.name, "names": self.vertices, "positions": self.positions},
                Labelling,
                "labels",
            )
        except InputError as error:
            raise InvalidWorld(str(error)) from None
        for key, given in (("names", labels.vertices), ("positions", labels.positions)):
            if len(given) not in (0, map_.vertex_count):
                raise InvalidWorld(
                    f"{key} = {show([*given])} is no list of {map_.vertex_count}, one for each "
                    "vertex of the map"
                )
        if not self.name.isprintable():
            raise InvalidWorld(f"name = {show(self.name)} is no printable text")
        first = {name: vertex for vertex, name in reversed([*enumerate(labels.vertices)])}
        for vertex, name in enumerate(labels.vertices):
            if not name.strip() or not name.isprintable() or first[name] < vertex:
                raise InvalidWorld(
                    f"names[{vertex}] = {show(name)} is no printable text of its own"
                )
        return labels

    def relabelled(
        self, map_: CombinatorialMap, names: Sequence[Dart], other: CombinatorialMap
    ) -> "Labelling":
        """The labels for ``other``, which is ``map_`` with each dart ``d`` renamed ``names[d]``."""
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
"""The empty labels: no name, no names of vertices, and no positions."""


def labels_of_nodes(
    name: object, nodes: Sequence[tuple[object, Mapping[str, Any]]], map_: CombinatorialMap
) -> Labelling:
    """The labels of a graph: its name, and the names and positions of its nodes.

    The name of a node is its attribute ``name``, or else the node itself.  If the names are the
    numbers 0, 1, 2, ..., the vertices get no names.  The position of a node is its attribute
    ``pos``; if a node has no legal position, the vertices get no positions.  If any label that
    remains is illegal, the result is :data:`PLAIN`: all labels are empty.

    Args:
        name: the name of the graph.
        nodes: each node with its attributes, in the order of the map's vertices.
        map_: the map of the graph.
    """
    names = [data.get("name", node) for node, data in nodes]
    if names == [*range(map_.vertex_count)]:
        names = []
    try:
        places = [tuple(map(float, data["pos"])) for _, data in nodes]
    except (KeyError, TypeError, ValueError):
        places = []
    try:
        return Labelling(str(name), tuple(map(str, names)), places).checked(map_)  # type: ignore[arg-type]  # that is checked
    except InvalidWorld:
        return PLAIN
