"""Algorithm 1 of the paper: mapping with one directional lighthouse.

One function for each group of lines; the paper's names S, U, H, M and P are kept in the
docstrings.  Every freedom that the paper leaves is a choice:

``edge``
    Which dart leaves U (line 3).  Options: U in the order in which its darts came into S;
    cost: the length of the shortest walk in S to the dart's vertex.
``transit``
    Which simple path in S leads to v_k (line 4), one dart at a time.
``hypothesis``
    Which hypothesis leaves H (line 8).  Options: H in the order of S; cost: the length of
    the shortest path to v0.
``path``
    Which simple path in S leads from v_k' to v0 (line 9), one dart at a time.

Options of ``transit`` and ``path``: the darts from which the goal can still be reached
without entering a vertex twice, those with the shortest way to go first, equals in the order
of S; cost: the length of that way.  So every simple path is one sequence of answers, and
answering 0 always takes a shortest one.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from functools import cached_property
from typing import TypeAlias, TypeVar, overload

from allworlds.explorers.partial_map import PartialMap
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol import Checkpoint, Choices, Estimate, Kind, Move, Percept

R = TypeVar("R")
Walk: TypeAlias = Generator[Move | Checkpoint, Percept, R]
"""A part of the exploration that ends with a value of type R."""


def nobody(_event: str) -> None:
    """The listener who is not there."""


def algorithm1(
    first: Percept,
    *,
    choices: Choices | None = None,
    notice: Callable[[str], None] = nobody,
) -> Walk[Estimate]:
    """Explore from a directional lighthouse: an estimate that is the same map, pose included.

    Args:
        first: what is sensed at v0 before any motion; it has a bearing.
        choices: answers every choice listed above (default: first in, first out).
        notice: told of each event: ``case-1``, ``case-2``, ``case-3`` (a test's outcome),
            ``v0-hypothesis`` (a test without a step, at v0), ``empty-H``, ``loop`` and
            ``non-loop`` (the augmentation).  It changes nothing.

    Cost: at most (1) + (2) of Section VI traversals.  Source: Algorithm 1, Section IV.
    """
    choices = choices or Choices()
    s = PartialMap(first)  # line 1
    here = 0
    while s.unexplored:  # line 2
        goal = _take_from_u(s, here, choices)
        percept = yield from _follow(s, here, goal, choices)
        hypotheses = [d for d in s.unexplored if d != goal and s.expected[d] == percept]  # line 6
        if not hypotheses:
            notice("empty-H")
        confirmed, turned = yield from _test_all(s, hypotheses, choices, notice)
        if confirmed is None:  # lines 20-21
            notice("non-loop")
            entry = s.add_vertex(goal, percept)
            here = s.turn(entry, turned)
        else:  # lines 18-19
            notice("loop")
            partner, here = confirmed
            s.add_loop(goal, partner)
        yield s.checkpoint(here)
    return Estimate(CombinatorialMap(s.sigma, s.alpha), here)  # line 22


def _take_from_u(s: PartialMap, here: int, choices: Choices) -> int:
    """Line 3: the dart e to be explored."""
    cost = _walks(s, s.vertex[here], s.unexplored)
    return choices.pick(s.unexplored, of="edge", cost=cost)


def _follow(s: PartialMap, here: int, goal: int, choices: Choices) -> Walk[Percept]:
    """Lines 4-5: walk through S to the known end of the dart, then follow it; the percept."""
    for dart in _simple_path(s, s.vertex[here], s.vertex[goal], choices, "transit"):
        yield Move(s.offset(here, dart))
        here = s.alpha[dart]
    return (yield Move(s.offset(here, goal)))


def _test_all(
    s: PartialMap, hypotheses: list[int], choices: Choices, notice: Callable[[str], None]
) -> Walk[tuple[tuple[int, int] | None, int]]:
    """Lines 7-17: test hypotheses until one is confirmed or H is empty.

    Returns:
        ``((e', here), 0)`` with the confirmed hypothesis and the robot's dart in S, or
        ``(None, turned)``: the robot is back at v_u, ``turned`` places clockwise of the dart
        by which it entered.
    """
    turned = 0
    while hypotheses:
        partner = choices.pick(hypotheses, of="hypothesis", cost=_walks(s, 0, hypotheses))
        hypotheses.remove(partner)  # line 8
        path = list(_simple_path(s, s.vertex[partner], 0, choices, "path"))  # line 9
        if not path:
            # At v0 the signature already holds the direction: the whole test is done.
            notice("v0-hypothesis")
        motions, matched = yield from _try_path(s, partner, path, turned)
        if matched:  # case (3)
            notice("case-3")
            return (partner, s.alpha[path[-1]] if path else partner), 0
        notice("case-2" if len(motions) == len(path) else "case-1")
        turned = yield from _retrace(motions)
    return None, turned


def _try_path(
    s: PartialMap, partner: int, path: list[int], turned: int
) -> Walk[tuple[list[int], bool]]:
    """Lines 10-13: execute the motions M while the percepts are those expected, P.

    Returns:
        The motions executed, counted from the dart of entry, and whether all matched.
    """
    motions: list[int] = []
    at = partner
    for dart in path:
        motion = s.offset(at, dart)
        seen = yield Move(motion - turned)
        turned = 0
        motions.append(motion)
        at = s.alpha[dart]
        if seen != s.expected[at]:
            return motions, False
    return motions, True


def _retrace(motions: list[int]) -> Walk[int]:
    """Line 15: undo the motions; how far the robot is now turned from its dart of entry.

    The run ``k1..kr`` is undone by ``0, -kr, ..., -k2``; the turn by ``-k1`` that is left
    costs nothing and is folded into the next motion.
    """
    back = 0
    for motion in reversed(motions):
        yield Move(back)
        back = -motion
    return motions[0]


def _simple_path(
    s: PartialMap, start: int, goal: int, choices: Choices, kind: Kind
) -> Iterator[int]:
    """The darts by which a simple path in S from vertex ``start`` leaves its vertices."""
    vertex = start
    visited: list[int] = []
    lengths = s.distances(goal) if start != goal else {}
    while vertex != goal:
        visited.append(vertex)
        options = _NextDarts(s, vertex, goal, visited, lengths)
        dart = choices.pick(options, of=kind, cost=options.cost)
        vertex = s.vertex[s.alpha[dart]]
        yield dart


class _NextDarts(Sequence[int]):
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
        self.cost = _Lazy(lambda: [length for length, _ in self._ranked])

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


class _Lazy(Sequence[int]):
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


def _walks(s: PartialMap, start: int, darts: list[int]) -> _Lazy:
    """For each dart the length of a shortest walk in S from vertex ``start`` to its vertex."""

    def compute() -> list[int]:
        lengths = s.distances(start)
        return [lengths[s.vertex[dart]] for dart in darts]

    return _Lazy(compute)
