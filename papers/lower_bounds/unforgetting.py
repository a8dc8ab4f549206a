"""Algorithm 1 that never forgets: the common part of its variants.

S are the settled vertices of the folded log (``settled_log.py``), U
their darts without a settled vertex at the other end, as in Algorithm 1.  A pass takes a dart from
U, goes through it, and asks which vertex lies behind it:

* a *hypothesis* is another dart of U; it is refuted as soon as gluing the two darts in the folded
  log leads to a contradiction, whenever and wherever the contradicting percept was seen;
* a *test* of one that is left walks its home word (a shortest way in S to v0), from the first step
  that the log does not know; the robot goes to that step by a shortest way in the log;
* when all are refuted the vertex is settled: it is a new one.

The answer is right, and the cost never above (1) + (2), for every choice of darts and hypotheses:
Theorem 1 of the page on the theory.  A variant makes just these choices:
:meth:`Unforgetting.next_dart` and :meth:`Unforgetting.trial`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Generator, Sequence
from typing import TypeAlias, TypeVar

from msgspec import Struct

from allworlds import Checkpoint, CombinatorialMap, Estimate, Move, Percept
from settled_log import OPEN, SettledLog

R = TypeVar("R")
Walk: TypeAlias = Generator[Move | Checkpoint, Percept, R]
"""A part of the exploration that ends with a value of type R."""
Settled: TypeAlias = Callable[[Checkpoint], None]
"""Told of S and U whenever a vertex is settled, wherever the robot is then: in place of the robot's
dart stands the one that it faced at the start.  It changes nothing."""


def nobody(_event: str) -> None:
    """Hear of an event, and do nothing."""


def unseen(_shown: Checkpoint) -> None:
    """See S and U, and do nothing."""


class Hypotheses(ABC):
    """The unrefuted hypotheses about the vertex behind a dart."""

    @abstractmethod
    def next_test(self) -> Test | None:
        """The test to be done next; None when every hypothesis is refuted."""

    @abstractmethod
    def learned(self, done: Test) -> None:
        """Take note that the log has grown by a test, or that nodes have been merged."""


class Test(Struct, frozen=True):
    """A hypothesis, with the part of its home word that the log does not know.

    Attributes:
        dart: of U, the one that the robot's dart of entry may be.
        front: the canonical dart of the log at which the word leaves it.
        stands_for: the dart of S that the robot would have come by to the front's node.
        steps: the number of steps of the word that are left.
    """

    dart: int
    front: int
    stands_for: int
    steps: int


class Spread:
    """The nodes of the log round one of them, layer by layer, with shortest ways to them.

    Attributes:
        layer: the nodes at the distance reached.
        distance: that distance.
    """

    def __init__(self, log: SettledLog, start: int) -> None:
        self._log = log
        self._by: dict[int, int] = {start: OPEN}
        self.layer = [start]
        self.distance = 0

    def __contains__(self, vertex: int) -> bool:
        return vertex in self._by

    def grow(self) -> None:
        """Go on to the nodes that are one step further."""
        known, node, beyond, by = self._log.known, self._log.node, self._log.beyond, self._by
        further = []
        for v in self.layer:
            for dart in known[v]:
                w = node[beyond(dart)]
                if w not in by:
                    by[w] = dart
                    further.append(w)
        self.layer = further
        self.distance += 1

    def way_to(self, vertex: int) -> list[int]:
        """The darts by which a shortest way from the start to a node leaves its nodes."""
        while vertex not in self._by:
            self.grow()
        way = []
        while (dart := self._by[vertex]) != OPEN:
            way.append(dart)
            vertex = self._log.node[dart]
        return way[::-1]


class Unforgetting(ABC):
    """The state of an exploration.

    Attributes:
        log: the folded log.
        here: the canonical dart by which the robot has come; at the start the one it faces.
        home: for each settled vertex the dart by which a shortest way in S to v0 leaves it.
        distance: for each settled vertex the length of that way.
        notice: told of events.
        settled: see :data:`Settled`.
        rank, entry: for each settled vertex its number in the order of settling, and its dart of
            entry.
    """

    def __init__(
        self, first: Percept, notice: Callable[[str], None], settled: Settled = unseen
    ) -> None:
        self.log = SettledLog(first)
        self.here = self._start = -(first.bearing or 0) % first.degree
        self.rank = {0: 0}
        self.entry = {0: self.here}
        self.home: dict[int, int] = {}
        self.distance: dict[int, int] = {}
        self.notice = notice
        self.settled = settled
        self._shown = 0
        self._look_home()

    @abstractmethod
    def next_dart(self, unexplored: list[int]) -> int:
        """The dart of U (its darts ascending) that is explored next."""

    @abstractmethod
    def trial(self, entry: int, suspects: list[int]) -> Hypotheses:
        """The hypotheses about the vertex of a dart of entry, of which none has been looked at."""

    def explore(self) -> Walk[Estimate]:
        """Make passes until U is empty; return the estimate."""
        while unexplored := self.unexplored():
            if self.log.settled[self.log.node[self.here]]:
                yield from self._show()
            entry = yield from self._cross(self.next_dart(unexplored))
            if entry == OPEN:
                self.notice("loop")
            else:
                yield from self._resolve(entry)
            self._look_home()
        yield from self._show()
        return self._answer()

    def is_settled(self, dart: int) -> bool:
        """Whether the vertex of a dart is settled."""
        return self.log.settled[self.log.node[self.log.canonical(dart)]]

    def is_explored(self, dart: int) -> bool:
        """Whether a settled vertex is known to lie at the other end of a settled vertex's dart."""
        other = self.log.beyond(dart)
        return other != OPEN and self.log.settled[self.log.node[other]]

    def unexplored(self) -> list[int]:
        """The darts of U, ascending."""
        log = self.log
        return [
            dart
            for v in sorted(self.rank)
            for dart in range(log.base[v], log.base[v] + log.degree[v])
            if not self.is_explored(dart)
        ]

    def place_in_s(self, dart: int) -> tuple[int, int]:
        """The key that sorts settled vertices' darts by when they came into S, then clockwise."""
        log = self.log
        v = log.node[dart]
        return self.rank[v], (dart - self.entry[v]) % log.degree[v]

    def nearer(self, dart: int, stands_for: int) -> tuple[int, int] | None:
        """The end of the known part of a home word, walked from a dart that may be one of S.

        Returns:
            The dart at which the word leaves the log and the one of S that the robot would have
            come by; None if the word is known to end elsewhere than at v0.
        """
        log, home = self.log, self.home
        node, base, degree, settled = log.node, log.base, log.degree, log.settled
        while (v := node[stands_for]) != 0:
            way = home[v]
            w = node[dart]
            first = base[w]
            leaves = first + (dart - first + way - stands_for) % degree[w]
            dart = log.beyond(leaves)
            if dart == OPEN:
                return leaves, stands_for
            stands_for = log.beyond(way)
            u, t = node[dart], node[stands_for]
            if degree[u] != degree[t] or (settled[u] and dart != stands_for) or (not u) != (not t):
                return None
        return None

    def test_of(self, dart: int, place: tuple[int, int] | None) -> Test | None:
        """The test that is left of a hypothesis, from the result of :meth:`nearer`."""
        if place is None:
            return None
        front, stands_for = place
        return Test(dart, front, stands_for, self.distance[self.log.node[stands_for]])

    def _look_home(self) -> None:
        """Find for each settled vertex the first dart of a shortest way in S to v0."""
        log = self.log
        self.distance, self.home = {0: 0}, {}
        for v in (queue := [0]):
            for dart in log.known[v]:
                other = log.beyond(dart)
                w = log.node[other]
                if log.settled[w] and w not in self.distance:
                    self.distance[w] = self.distance[v] + 1
                    self.home[w] = other
                    queue.append(w)

    def _step(self, dart: int) -> Walk[Percept]:
        """Leave by a canonical dart of the robot's node."""
        percept = yield Move(dart - self.here)
        self.here = self.log.arrive(dart, percept)
        return percept

    def _follow(self, way: Sequence[int]) -> Walk[None]:
        for dart in way:
            yield from self._step(dart)

    def _go_to(self, vertex: int) -> Walk[None]:
        if self.log.node[self.here] != vertex:
            yield from self._follow(Spread(self.log, self.log.node[self.here]).way_to(vertex))

    def _cross(self, dart: int) -> Walk[int]:
        """Go through a dart of U, unless that has been done.

        Returns:
            The dart of entry of the unsettled vertex behind it, or :data:`OPEN` if it is settled.
        """
        log = self.log
        if log.beyond(dart) == OPEN:
            yield from self._go_to(log.node[dart])
            yield from self._show()
            yield from self._step(dart)
        return OPEN if self.is_explored(dart) else log.beyond(dart)

    def _resolve(self, entry: int) -> Walk[None]:
        """Test the hypotheses about a vertex until one is confirmed, or the vertex is new."""
        log = self.log
        came_by = log.beyond(entry)
        degree = log.degree[log.node[entry]]
        suspects = [
            dart
            for dart in self.unexplored()
            if dart != came_by and log.node[dart] > 0 and log.degree[log.node[dart]] == degree
        ]
        if not suspects:
            self.notice("empty-H")
        hypotheses = self.trial(entry, suspects)
        while test := hypotheses.next_test():
            yield from self._do(test)
            if self.is_settled(entry):
                self.notice("loop")
                return
            hypotheses.learned(test)
        self.notice("non-loop")
        entry = log.canonical(entry)
        vertex = log.node[entry]
        log.settled[vertex] = True
        self.rank[vertex], self.entry[vertex] = len(self.rank), entry
        if self.settled is not unseen:
            self.settled(self._checkpoint(self._start, {*self.unexplored()}))

    def _do(self, test: Test) -> Walk[None]:
        """Go to the end of the log, and on with the home word to a mismatch or v0."""
        log = self.log
        yield from self._go_to(log.node[test.front])
        dart, stands_for = test.front, test.stands_for
        while True:
            stands_for = log.beyond(self.home[log.node[stands_for]])
            percept = yield from self._step(dart)
            vertex = log.node[stands_for]
            if percept.marks or not vertex:
                self.notice("case-2" if percept.marks else "case-1")
                return
            if log.degree[vertex] != percept.degree:
                self.notice("case-1")
                return
            dart = log.turn(self.here, self.home[vertex] - stands_for)

    def _show(self) -> Walk[None]:
        """Publish S and U if S has grown since the last time; the robot is at a vertex of S."""
        log = self.log
        unexplored = set(self.unexplored())
        size = sum(log.degree[v] for v in self.rank)
        if size - len(unexplored) > self._shown:
            self._shown = size - len(unexplored)
            yield self._checkpoint(self.here, unexplored)

    def _checkpoint(self, here: int, unexplored: set[int]) -> Checkpoint:
        """S with its darts numbered from 0, and one of them."""
        log = self.log
        sigma: list[int] = []
        number: dict[int, int] = {}
        for v in sorted(self.rank):
            first, size = len(sigma), log.degree[v]
            sigma += [*range(first + 1, first + size), first]
            number |= {log.base[v] + i: first + i for i in range(size)}
        alpha = [
            i if dart in unexplored else number[log.beyond(dart)] for dart, i in number.items()
        ]
        return Checkpoint(tuple(sigma), tuple(alpha), number[here])

    def _answer(self) -> Estimate:
        done = self._checkpoint(self.here, set())
        return Estimate(CombinatorialMap(done.sigma, done.alpha), done.here)
