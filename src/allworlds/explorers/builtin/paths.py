"""Simple paths in S, chosen one dart at a time, and walking distances for the choices."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import overload

from allworlds.explorers.builtin.partial_map import PartialMap
from allworlds.protocol import Choices, Kind


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


class NextDarts(Sequence[int]):
    """The options of one step of a path.  The first is found without looking at the others.

    While a path has only taken first options it is a shortest one, and the first option is
    the first dart that is one step nearer to the goal.
    """

    def __init__(
        self, s: PartialMap, vertex: int, goal: int, visited: list[int], lengths: dict[int, int]
    ) -> None:
        self._s, self._vertex, self._goal = s, vertex, goal
        self._visited = tuple(visited)
        self._lengths = lengths
        self.cost = Lazy(lambda: [length for length, _ in self._ranked])

    def __len__(self) -> int:
        return len(self._ranked)

    @overload
    def __getitem__(self, index: int) -> int: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[int]: ...
    def __getitem__(self, index: int | slice) -> int | Sequence[int]:
        if index == 0 and self._on_a_shortest_path():
            nearer = self._lengths[self._vertex] - 1
            ways = self._s.ways(self._vertex)
            return next(dart for dart, other in ways if self._lengths[other] == nearer)
        darts = [dart for _, dart in self._ranked]
        return darts[index]

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


class Lazy(Sequence[int]):
    """Costs that are computed when a policy looks at the first of them."""

    def __init__(self, compute: Callable[[], list[int]]) -> None:
        self._compute = compute

    @cached_property
    def _values(self) -> list[int]:
        return self._compute()

    def __len__(self) -> int:
        return len(self._values)

    @overload
    def __getitem__(self, index: int) -> int: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[int]: ...
    def __getitem__(self, index: int | slice) -> int | Sequence[int]:
        return self._values[index]


def walks(s: PartialMap, start: int, darts: list[int]) -> Lazy:
    """For each dart the length of a shortest walk in S from vertex ``start`` to its vertex."""

    def compute() -> list[int]:
        lengths = s.distances(start)
        return [lengths[s.vertex[dart]] for dart in darts]

    return Lazy(compute)
