"""The paper's S and U: the part of the world that a robot has mapped so far."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from allworlds.protocol import Checkpoint, Percept


def bearing_of(percept: Percept) -> int:
    """The bearing that an explorer cannot do without.

    Raises:
        ValueError: if the lighthouse shows none here.
    """
    if percept.bearing is None:
        raise ValueError("this explorer needs a bearing here, and the lighthouse shows none")
    return percept.bearing


class PartialMap:
    """S with its open darts U, as Algorithm 1 builds it.

    The darts of a vertex are consecutive and clockwise; dart 0 is the one that the robot
    faces at the start, and the first dart of every later vertex is the one by which the
    robot discovered it.

    Attributes:
        sigma, alpha: the permutations so far; ``alpha[d] == d`` for an open dart.
        vertex: for each dart its vertex; vertex 0 is v0.
        first: for each vertex its first dart.
        expected: for each dart the percept of a robot that has arrived by it.
        unexplored: U, in the order in which its darts came into S.
    """

    def __init__(self, first: Percept) -> None:
        self.sigma: list[int] = []
        self.alpha: list[int] = []
        self.vertex: list[int] = []
        self.first: list[int] = []
        self.expected: list[Percept] = []
        self.unexplored: list[int] = []
        self._add_vertex(first)
        bearing = first.bearing
        if bearing is not None:
            self.expected = [
                Percept(first.degree, first.marks, (bearing - d) % first.degree)
                for d in range(first.degree)
            ]

    def offset(self, start: int, end: int) -> int:
        """The motion from dart ``start`` to dart ``end`` of the same vertex."""
        return (end - start) % self.expected[start].degree

    def turn(self, dart: int, offset: int) -> int:
        """The dart ``sigma^offset(dart)``."""
        first = self.first[self.vertex[dart]]
        return first + (dart - first + offset) % self.expected[dart].degree

    def add_vertex(self, dart: int, percept: Percept) -> int:
        """Lines 20-21: add a vertex behind the explored ``dart``; return its first dart.

        The other darts of the vertex join U.
        """
        entry = self._add_vertex(percept)
        self._explore(dart, entry)
        return entry

    def add_loop(self, dart: int, partner: int) -> None:
        """Lines 18-19: join the explored ``dart`` to ``partner``, which leaves U."""
        self._explore(dart, partner)

    def ways(self, vertex: int) -> Iterator[tuple[int, int]]:
        """The explored darts of a vertex, clockwise, each with the vertex it leads to."""
        first = self.first[vertex]
        for dart in range(first, first + self.expected[first].degree):
            other = self.alpha[dart]
            if other != dart:
                yield dart, self.vertex[other]

    def distances(self, goal: int, avoiding: Sequence[int] = ()) -> dict[int, int]:
        """For each vertex the length of a shortest walk in S to ``goal``.

        Walks do not enter the vertices of ``avoiding``; vertices without a walk are missing.
        Cost: O(m).
        """
        length = {goal: 0}
        for vertex in (queue := [goal]):
            for _, other in self.ways(vertex):
                if other not in length and other not in avoiding:
                    length[other] = length[vertex] + 1
                    queue.append(other)
        return length

    def checkpoint(self, here: int) -> Checkpoint:
        """S and U as a checkpoint, with the robot's dart."""
        return Checkpoint(tuple(self.sigma), tuple(self.alpha), here)

    def _add_vertex(self, percept: Percept) -> int:
        start, degree = len(self.sigma), percept.degree
        darts = range(start, start + degree)
        self.sigma.extend(darts[1:])
        self.sigma.append(start)
        self.alpha.extend(darts)
        self.vertex.extend([len(self.first)] * degree)
        self.first.append(start)
        self.expected.extend([percept] * degree)
        self.unexplored.extend(darts)
        return start

    def _explore(self, dart: int, partner: int) -> None:
        self.alpha[dart], self.alpha[partner] = partner, dart
        self.unexplored.remove(dart)
        self.unexplored.remove(partner)
