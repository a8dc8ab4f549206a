"""The map so far, and paths in it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import Any

from allworlds.protocol.actions import Percept
from allworlds.protocol.answers import Checkpoint
from allworlds.protocol.choices import Choices, Kind


def bearing_of(percept: Percept) -> int:
    """The bearing that an explorer cannot do without."""
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
        self.add_loop(dart, entry)
        return entry

    def add_loop(self, dart: int, partner: int) -> None:
        """Lines 18-19: join the explored ``dart`` to ``partner``, which leaves U."""
        self.alpha[dart], self.alpha[partner] = partner, dart
        self.unexplored.remove(dart)
        self.unexplored.remove(partner)

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


def simple_path(
    s: PartialMap, start: int, goal: int, choices: Choices, kind: Kind
) -> Iterator[int]:
    """The darts by which a simple path in S from vertex ``start`` leaves its vertices."""
    vertex = start
    visited: list[int] = []
    lengths = s.distances(goal) if start != goal else {}
    while vertex != goal:
        visited.append(vertex)
        options = NextDarts(s, vertex, goal, visited, lengths)
        dart = choices.pick(options, of=kind, cost=options.cost)
        vertex = s.vertex[s.alpha[dart]]
        yield dart


class Lazy(Sequence[int]):
    """Integers that are computed when a policy looks at the first of them."""

    def __init__(self, compute: Callable[[], list[int]]) -> None:
        self._compute = compute

    @cached_property
    def _values(self) -> list[int]:
        return self._compute()

    def __len__(self) -> int:
        return len(self._values)

    def __getitem__(self, index: Any) -> Any:
        return self._values[index]


class NextDarts(Lazy):
    """The options of one step of a path.  The first is found without looking at the others.

    While a path has only taken first options it is a shortest one, and the first option is
    the first dart that is one step nearer to the goal.
    """

    def __init__(
        self, s: PartialMap, vertex: int, goal: int, visited: list[int], lengths: dict[int, int]
    ) -> None:
        super().__init__(lambda: [dart for _, dart in self._ranked])
        self._s, self._vertex, self._goal = s, vertex, goal
        self._visited = tuple(visited)
        self._lengths = lengths
        self.cost = Lazy(lambda: [length for length, _ in self._ranked])

    def __getitem__(self, index: Any) -> Any:
        if index == 0 and self._on_a_shortest_path():
            nearer = self._lengths[self._vertex] - 1
            ways = self._s.ways(self._vertex)
            return next(dart for dart, other in ways if self._lengths[other] == nearer)
        return super().__getitem__(index)

    def _on_a_shortest_path(self) -> bool:
        steps = len(self._visited) - 1
        return self._lengths[self._vertex] + steps == self._lengths[self._visited[0]]

    @cached_property
    def _ranked(self) -> list[tuple[int, int]]:
        """``(length of the way to go, dart)`` for every option, ascending."""
        lengths = self._s.distances(self._goal, self._visited)
        return sorted(
            (lengths[other] + 1, dart)
            for dart, other in self._s.ways(self._vertex)
            if other in lengths and other not in self._visited
        )


def walks(s: PartialMap, start: int, darts: list[int]) -> Lazy:
    """For each dart the length of a shortest walk in S from vertex ``start`` to its vertex."""

    def compute() -> list[int]:
        lengths = s.distances(start)
        return [lengths[s.vertex[dart]] for dart in darts]

    return Lazy(compute)
