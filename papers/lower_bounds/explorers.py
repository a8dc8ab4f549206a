"""Explorers that never forget: ``remembering``, ``greedy``, ``prudent``.

All three are Algorithm 1 on the folded log of the whole walk (:mod:`unforgetting`); they differ in
which dart and which hypothesis comes next.

``prudent`` is greedy in round worlds, and near v0 first in long ones.  In a world that is as round
as a lattice every place is near v0, and the nearest dart is the best.  In a long one (a thick path,
a prism) the nearest dart leads away from v0, where tests are expensive, and leaves open darts
behind, each of which is a hypothesis in every later pass.  The settled part of the map shows which
of the two the world is.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from functools import cached_property
from heapq import heapify, heappop, heappush
from math import inf
from typing import overload

from allworlds import Choices, Estimate, Percept
from unforgetting import Hypotheses, Settled, Spread, Test, Unforgetting, Walk, nobody, unseen

HOME = 4
"""The weight of a step between a dart and v0 in a long world, in steps of the robot."""


def remembering(
    first: Percept,
    *,
    choices: Choices | None = None,
    notice: Callable[[str], None] = nobody,
    settled: Settled = unseen,
) -> Walk[Estimate]:
    """Explore from a directional lighthouse; return an estimate equal to the world, pose included.

    Args:
        first: the percept at v0 before any motion; it has a bearing.
        choices: ``edge``: the dart that leaves U; cost: the shortest walk to its vertex through all
            known edges.  ``hypothesis``: the unrefuted one that is tested; cost:
            the length of its home word.  Options stand in the order in which they came into S.
            Default: first in, first out.
        notice: told of ``empty-H`` (no dart of U has the degree), ``case-1`` (a test that ends
            short of v0, or does not find it at its end), ``case-2`` (a test that comes to v0),
            ``loop`` and ``non-loop`` (how a pass ends).
        settled: told of S when it grows.

    Cost: at most (1) + (2) of Section VI traversals, for all choices.
    """
    return (yield from _Remembering(first, choices or Choices(), notice, settled).explore())


class _Remembering(Unforgetting):
    def __init__(
        self,
        first: Percept,
        choices: Choices,
        notice: Callable[[str], None],
        settled: Settled = unseen,
    ) -> None:
        super().__init__(first, notice, settled)
        self.choices = choices

    def next_dart(self, unexplored: list[int]) -> int:
        options = sorted(unexplored, key=self.place_in_s)

        def cost() -> list[int]:
            spread = Spread(self.log, self.log.node[self.here])
            return [len(spread.way_to(self.log.node[dart])) for dart in options]

        return self.choices.pick(options, of="edge", cost=Lazy(cost))

    def trial(self, entry: int, suspects: list[int]) -> Hypotheses:
        return _InOrder(self, entry, sorted(suspects, key=self.place_in_s))


class _InOrder(Hypotheses, Sequence[Test]):
    """The unrefuted hypotheses, in the order of S; each is checked when it is asked for."""

    def __init__(self, exploration: _Remembering, entry: int, suspects: list[int]) -> None:
        self._at, self._entry = exploration, entry
        self._alive: list[Test] = []
        self._left = suspects[::-1]

    def next_test(self) -> Test | None:
        if not self._reaches(1):
            return None
        cost = Lazy(lambda: [self._at.distance[self._at.log.node[test.dart]] for test in self])
        return self._at.choices.pick(self, of="hypothesis", cost=cost)

    def learned(self, done: Test) -> None:
        # What was alive may be refuted by now, and its word known further.
        self._left += [test.dart for test in reversed(self._alive) if test is not done]
        self._alive = []

    def __len__(self) -> int:
        self._reaches(len(self._alive) + len(self._left))
        return len(self._alive)

    @overload
    def __getitem__(self, index: int) -> Test: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Test]: ...
    def __getitem__(self, index: int | slice) -> Test | Sequence[Test]:
        if not isinstance(index, int) or index < 0:
            return [*self][index]
        self._reaches(index + 1)
        return self._alive[index]

    def _reaches(self, count: int) -> bool:
        """Whether there are at least ``count`` unrefuted hypotheses."""
        at = self._at
        entry = at.log.canonical(self._entry)
        while self._left and len(self._alive) < count:
            dart = self._left.pop()
            if at.is_explored(dart):
                continue
            test = at.test_of(dart, at.nearer(entry, dart))
            if test and not at.log.contradicts(entry, dart):
                self._alive.append(test)
        return len(self._alive) >= count


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


def greedy(
    first: Percept, *, notice: Callable[[str], None] = nobody, settled: Settled = unseen
) -> Walk[Estimate]:
    """Explore from a directional lighthouse; return an estimate equal to the world, pose included.

    The next dart is the one nearest to the robot, the next test the one that is finished first.

    Args:
        first: the percept at v0 before any motion; it has a bearing.
        notice: told of the events of
            :func:`remembering`.
        settled: told of S when it grows.

    Cost: at most (1) + (2) of Section VI traversals.
    """
    return (yield from Greedy(first, notice, settled).explore())


class Greedy(Unforgetting):
    """The state of an exploration that takes the nearest dart and test."""

    def next_dart(self, unexplored: list[int]) -> int:
        """The nearest dart; equals clockwise from the robot's if at its vertex, else by number."""
        log = self.log
        darts = defaultdict(list)
        for dart in unexplored:
            darts[log.node[dart]].append(dart)
        here = log.node[self.here]
        if here in darts:
            return min(darts[here], key=lambda dart: (dart - self.here) % log.degree[here])
        spread = Spread(log, here)
        while not any(v in darts for v in spread.layer):
            spread.grow()
        nearest = [dart for v in spread.layer for dart in darts.get(v, ())]
        return min(nearest, key=lambda dart: (dart - log.base[log.node[dart]], dart))

    def trial(self, entry: int, suspects: list[int]) -> Hypotheses:
        """The hypotheses, sorted by when they could be decided."""
        return FirstDecided(self, entry, suspects)


class FirstDecided(Hypotheses):
    """Hypotheses, sorted by when the robot could have finished their test.

    They wait at the nodes where their words leave the log, in heaps of
    ``(steps left, distance home, dart, test)``.
    """

    def __init__(self, exploration: Unforgetting, entry: int, suspects: list[int]) -> None:
        self._at, self._entry = exploration, entry
        self._waiting: dict[int, list[tuple[int, int, int, Test]]] = {}
        self._merges = exploration.log.merges
        self._place(suspects)

    def _place(self, suspects: list[int]) -> None:
        at = self._at
        entry = at.log.canonical(self._entry)
        for dart in suspects:
            if not at.is_explored(dart):
                self._wait(at.test_of(dart, at.nearer(entry, dart)))

    def _wait(self, test: Test | None) -> None:
        if test:
            log = self._at.log
            home = self._at.distance[log.node[test.dart]]
            heap = self._waiting.setdefault(log.node[test.front], [])
            heappush(heap, (test.steps, home, test.dart, test))

    def next_test(self) -> Test | None:
        """The unrefuted test that is finished first; equals by way home, then by number."""
        at, waiting = self._at, self._waiting
        if not waiting:
            return None
        entry = at.log.canonical(self._entry)
        spread = Spread(at.log, at.log.node[at.here])
        heads: list[tuple[int, int, int, int, int]] = []
        unseen = len(waiting)
        least = min(heap[0][0] for heap in waiting.values())
        while waiting:
            for v in spread.layer:
                if v in waiting:
                    unseen -= 1
                    steps, home, dart, _ = waiting[v][0]
                    heappush(heads, (spread.distance + steps, home, dart, v, spread.distance))
            further = spread.distance + 1 + least if unseen else None
            while heads and (further is None or heads[0][0] < further):
                _, _, dart, v, distance = heappop(heads)
                test = heappop(waiting[v])[-1]
                refuted = at.log.contradicts(entry, dart)
                if not refuted:
                    self._kept(v)
                    return test
                if waiting[v]:
                    steps, home, dart, _ = waiting[v][0]
                    heappush(heads, (distance + steps, home, dart, v, distance))
                else:
                    del waiting[v]
            if unseen:
                spread.grow()
        return None

    def _kept(self, vertex: int) -> None:
        if not self._waiting[vertex]:
            del self._waiting[vertex]

    def learned(self, done: Test) -> None:
        """Move the hypotheses of which the test has made more steps known."""
        at, log = self._at, self._at.log
        if log.merges != self._merges:
            self._merges = log.merges
            darts = [dart for heap in self._waiting.values() for _, _, dart, _ in heap]
            self._waiting = {}
            self._place(darts)
            return
        vertex = log.node[done.front]
        heap = self._waiting.pop(vertex, [])
        stay = [item for item in heap if item[-1].front != done.front]
        if stay:
            heapify(stay)
            self._waiting[vertex] = stay
        for *_, test in heap:
            if test.front == done.front:
                here = log.turn(test.front, test.stands_for - at.home[log.node[test.stands_for]])
                self._wait(at.test_of(test.dart, at.nearer(here, test.stands_for)))


def prudent(
    first: Percept, *, notice: Callable[[str], None] = nobody, settled: Settled = unseen
) -> Walk[Estimate]:
    """Explore from a directional lighthouse; return an estimate equal to the world, pose included.

    While the settled part is round this is :func:`greedy`.
    While it is long, the next dart is the one with the least sum of the robot's way to it and, four
    times, its way to v0.

    Args:
        first: the percept at v0 before any motion; it has a bearing.
        notice: told of the events of
            :func:`remembering`.
        settled: told of S when it grows.

    Cost: at most (1) + (2) of Section VI traversals.
    """
    return (yield from Prudent(first, notice, settled).explore())


class Prudent(Greedy):
    """The state of an exploration that stays near v0 while the settled part is long."""

    def next_dart(self, unexplored: list[int]) -> int:
        """The nearest dart, or in a long world the one nearest to v0 and the robot."""
        if not self._is_long():
            return super().next_dart(unexplored)
        log = self.log
        darts = defaultdict(list)
        for dart in unexplored:
            darts[log.node[dart]].append(dart)
        here = log.node[self.here]
        spread = Spread(log, here)
        best: tuple[float, int, int] = (inf, 0, 0)
        while darts and spread.distance <= best[0]:
            for v in spread.layer:
                turned = self.here if v == here else log.base[v]
                for dart in darts.pop(v, ()):
                    cost = spread.distance + HOME * self.distance[v]
                    best = min(best, (cost, (dart - turned) % log.degree[v], dart))
            spread.grow()
        return best[2]

    def _is_long(self) -> bool:
        """Whether one of the s settled vertices is further than 3/2 sqrt(s) from v0."""
        return 4 * max(self.distance.values()) ** 2 > 9 * len(self.distance)
