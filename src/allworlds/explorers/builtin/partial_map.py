"""The map so far, and paths in it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache, cached_property
from typing import Any

from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol.actions import Percept
from allworlds.protocol.answers import Checkpoint, Estimate
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
        if (bearing := first.bearing) is not None:
            degree, marks = first.degree, first.marks
            self.expected = [Percept(degree, marks, (bearing - d) % degree) for d in range(degree)]

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

    def estimate(self, here: int) -> Estimate:
        """S as the answer, with the robot's dart; no dart may be open."""
        return Estimate(CombinatorialMap(self.sigma, self.alpha), here)

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


class Lazy(Sequence[int]):
    """Integers that are computed when a policy looks at them; the first may be known before."""

    def __init__(self, compute: Callable[[], list[int]], first: int | None = None) -> None:
        self._compute, self._first = compute, first

    @cached_property
    def _values(self) -> list[int]:
        return self._compute()

    def __len__(self) -> int:
        return len(self._values)

    def __getitem__(self, index: Any) -> Any:
        if index == 0 and self._first is not None:
            return self._first
        return self._values[index]


def walks(s: PartialMap, start: int, darts: list[int]) -> Lazy:
    """For each dart the length of a shortest walk in S from vertex ``start`` to its vertex."""

    def compute() -> list[int]:
        lengths = s.distances(start)
        return [lengths[s.vertex[dart]] for dart in darts]

    return Lazy(compute)


def simple_path(
    s: PartialMap, start: int, goal: int, choices: Choices, kind: Kind
) -> Iterator[int]:
    """The darts by which a simple path in S from vertex ``start`` leaves its vertices."""
    vertex = start
    visited: list[int] = []
    lengths = s.distances(goal) if start != goal else {}
    while vertex != goal:
        visited.append(vertex)
        options, costs = _next_darts(s, goal, visited, lengths)
        dart = choices.pick(options, of=kind, cost=costs)
        vertex = s.vertex[s.alpha[dart]]
        yield dart


def _next_darts(
    s: PartialMap, goal: int, visited: list[int], lengths: dict[int, int]
) -> tuple[Lazy, Lazy]:
    """The options of the next step of a path through these vertices, and the ways to go.

    While a path has only taken first options it is a shortest one, and the first option is the
    first dart that is one step nearer to the goal: the others need not be known for that.
    """
    vertex = visited[-1]

    @cache
    def ranked() -> list[tuple[int, int]]:
        left = s.distances(goal, visited)
        return sorted((left[other] + 1, dart) for dart, other in s.ways(vertex) if other in left)

    first = None
    if lengths[vertex] + len(visited) - 1 == lengths[visited[0]]:
        first = next(d for d, other in s.ways(vertex) if lengths[other] == lengths[vertex] - 1)
    options = Lazy(lambda: [dart for _, dart in ranked()], first)
    return options, Lazy(lambda: [length for length, _ in ranked()])
