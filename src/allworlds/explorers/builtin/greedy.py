"""Algorithm 1 that never forgets and takes the nearest dart, and the test that ends first."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from heapq import heapify, heappop, heappush

from allworlds.explorers.builtin.algorithm1 import nobody, unseen
from allworlds.explorers.builtin.unforgetting import (
    Hypotheses,
    Settled,
    Spread,
    Test,
    Unforgetting,
    Walk,
)
from allworlds.protocol import Estimate, Percept


def greedy(
    first: Percept, *, notice: Callable[[str], None] = nobody, settled: Settled = unseen
) -> Walk[Estimate]:
    """Explore from a directional lighthouse; return an estimate equal to the world, pose included.

    The next dart is the one nearest to the robot, the next test the one that is finished first.

    Args:
        first: the percept at v0 before any motion; it has a bearing.
        notice: told of the events of
            :func:`allworlds.explorers.builtin.remembering.remembering`.
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


__all__ = ["FirstDecided", "Greedy", "greedy"]
