"""The folded log, and explorers that only fold: right if they stop, in whatever way they walk.

All percepts of a robot with a directional lighthouse are one map, the folded log.  Every vertex
that the robot stood on is a *node*.  Nodes are merged when an arrival at v0 shows that they are one
vertex, and with them all nodes that follow, because a dart leads to one dart only.  So the folded
log is a part of every world that agrees with the log, and where no dart of it is open it is the
world.

Which open dart is next is left to a *way*, and it must be a fair one: every dart that is open is
walked through some day, or closed by others.  Then every vertex that was entered is left some day
by its way home, and merged; so it ends.  The open dart that is nearest to the robot is not fair:
the robot can walk on for ever, from copy to copy.
"""

from __future__ import annotations

from bisect import insort
from collections.abc import Callable, Iterator
from typing import TypeAlias

from allworlds.explorers.builtin.algorithm1 import Walk, nobody
from allworlds.explorers.builtin.partial_map import bearing_of
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.answers import Estimate
from allworlds.protocol.choices import Choices

OPEN = -1
"""The other end of a dart that the robot has not gone through."""


class FoldedLog:
    """Nodes with consecutive, clockwise darts, merged by union-find with offsets.

    Node 0 is v0; its dart 0 is the one that the marker points at.  A dart is *canonical* if its
    node has not been merged into another.

    Attributes:
        node: for each dart its node, as it was when the dart was new.
        base, degree: for each node its first dart and how many it has.
        stands: for each node the dart that its first dart is; its own if it is canonical.
        known: for each canonical node its darts whose other end is known, ascending.
        merges: how many nodes have been merged.

    Cost: nearly constant a step, except that a merged node hands over its known darts.
    """

    def __init__(self, first: Percept) -> None:
        self.node: list[int] = []
        self.base: list[int] = []
        self.degree: list[int] = []
        self.stands: list[int] = []
        self.known: list[list[int]] = []
        self.merges = 0
        self._link: list[int] = []
        self._add_node(first.degree)

    def _add_node(self, degree: int) -> int:
        """Add a node; return its first dart."""
        first = len(self.node)
        self.node.extend([len(self.base)] * degree)
        self.base.append(first)
        self.degree.append(degree)
        self.stands.append(first)
        self.known.append([])
        self._link.extend([OPEN] * degree)
        return first

    def canonical(self, dart: int) -> int:
        """The dart of a canonical node that this dart is."""
        base, stands = self.base, self.stands
        v = self.node[dart]
        while stands[v] != base[v]:
            w = self.node[stands[v]]
            if stands[w] != base[w]:  # path halving
                stands[v] = self.turn(stands[w], stands[v] - base[w])
            dart = self.turn(stands[v], dart - base[v])
            v = self.node[dart]
        return dart

    def turn(self, dart: int, offset: int) -> int:
        """The dart ``sigma^offset(dart)``."""
        v = self.node[dart]
        first = self.base[v]
        return first + (dart - first + offset) % self.degree[v]

    def beyond(self, dart: int) -> int:
        """The canonical dart at the other end of a canonical dart's edge, or :data:`OPEN`."""
        other = self._link[dart]
        if other == OPEN:
            return OPEN
        v = self.node[other]
        if self.stands[v] != self.base[v]:
            other = self._link[dart] = self.canonical(other)
        return other

    def arrive(self, dart: int, percept: Percept) -> int:
        """The canonical dart that the robot has come by, after it has left by canonical ``dart``.

        Raises:
            ValueError: if the percepts contradict each other: no one world shows them all.
        """
        other = self.beyond(dart)
        if other == OPEN:
            other = self._add_node(percept.degree)
            self._link[dart], self._link[other] = other, dart
            insort(self.known[self.node[dart]], dart)
            self.known[self.node[other]].append(other)
            if percept.marks and percept.bearing is not None:
                self._merge(0, self.turn(other, percept.bearing))
        return self.canonical(other)

    def _differ(self, _v: int, _w: int) -> bool:
        """Whether two nodes of the same degree are known to be two vertices."""
        return False

    def _stays(self, v: int, w: int) -> bool:
        """Whether the first of two nodes stays when they are merged: the older one does."""
        return v < w

    def _merge(self, one: int, another: int) -> None:
        """Merge two darts, and all darts that are equal in consequence."""
        node, base, degree, link = self.node, self.base, self.degree, self._link
        equal = [(one, another)]
        while equal:
            a, b = map(self.canonical, equal.pop())
            v, w = node[a], node[b]
            if v == w and a == b:
                continue
            if v == w or degree[v] != degree[w] or self._differ(v, w):
                raise ValueError("the percepts contradict each other: no world shows them all")
            if not self._stays(v, w):
                a, b, v, w = b, a, w, v
            self.merges += 1
            self.stands[w] = self.turn(a, base[w] - b)
            for x in self.known[w]:
                y = self.turn(a, x - b)
                if link[y] == OPEN:
                    link[y] = link[x]
                    insort(self.known[v], y)
                else:
                    equal.append((link[y], link[x]))
            self.known[w] = []


# ---------------------------------------------------------------- explorers

Way: TypeAlias = Callable[[FoldedLog, int], list[int]]
"""The darts to leave by, one after the other, from the robot's dart to the end of an open one."""


def folding(
    first: Percept,
    *,
    choices: Choices | None = None,  # noqa: ARG001  # its way leaves none
    notice: Callable[[str], None] = nobody,
) -> Walk[Estimate]:
    """Go home to v0, then to the open dart that is nearest to v0.

    An event is ``merged``, an arrival at v0 that makes nodes one.

    Cost: the explorer stops; no bound is known (up to 1,206 traversals for m = 5).
    """
    return (yield from explore_folding(first, by_home, notice))


def folding_oldest(
    first: Percept,
    *,
    choices: Choices | None = None,  # noqa: ARG001  # its way leaves none
    notice: Callable[[str], None] = nobody,
) -> Walk[Estimate]:
    """Go a shortest way to the dart that is open for the longest time; else as :func:`folding`."""
    return (yield from explore_folding(first, to_oldest, notice))


def by_home(log: FoldedLog, here: int) -> list[int]:
    """The way to v0, then to the open dart nearest to it, clockwise from the pointed dart."""
    home = way(log, here, lambda dart: log.node[dart] == 0)
    return [*home[:-1], *way(log, 0, lambda dart: log.beyond(dart) == OPEN)]


def to_oldest(log: FoldedLog, here: int) -> list[int]:
    """The way to the open dart with the smallest number, which is the oldest."""
    oldest = next(dart for dart in _darts(log) if log.beyond(dart) == OPEN)
    return way(log, here, lambda dart: dart == oldest)


def explore_folding(
    first: Percept, next_way: Way, hears: Callable[[str], None] = nobody
) -> Walk[Estimate]:
    """Walk these ways and fold the percepts until no dart is open."""
    log, here = begun(first)
    while has_open_dart(log):
        for dart in next_way(log, here):
            seen = yield Move((dart - here) % log.degree[log.node[here]])
            merges = log.merges
            here = log.arrive(dart, seen)
            if log.merges > merges:
                hears("merged")
    return estimate(log, here)


def begun(first: Percept) -> tuple[FoldedLog, int]:
    """The log of the first percept, which has a bearing, and the dart that the robot faces."""
    log = FoldedLog(first)
    return log, log.turn(0, -bearing_of(first))


def has_open_dart(log: FoldedLog) -> bool:
    """Whether a dart is open, so that the log does not determine the map yet."""
    return any(log.beyond(dart) == OPEN for dart in _darts(log))


def estimate(log: FoldedLog, here: int) -> Estimate:
    """The folded map, with the robot's dart in it; no dart may be open."""
    darts = [*_darts(log)]
    number = {dart: i for i, dart in enumerate(darts)}
    sigma = [number[log.turn(dart, 1)] for dart in darts]
    alpha = [number[log.beyond(dart)] for dart in darts]
    return Estimate(CombinatorialMap(sigma, alpha), number[here])


def _darts(log: FoldedLog) -> Iterator[int]:
    """The canonical darts, ascending."""
    for first, degree, stands in zip(log.base, log.degree, log.stands, strict=True):
        if stands == first:
            yield from range(first, first + degree)


def way(log: FoldedLog, start: int, is_goal: Callable[[int], bool]) -> list[int]:
    """The darts by which a shortest walk leaves, up to the first dart that is a goal.

    Darts of one node are looked at clockwise, from its dart of entry on.
    """
    came: dict[int, list[int]] = {log.node[start]: []}
    queue = [start]
    for entry in queue:
        darts = [log.turn(entry, k) for k in range(log.degree[log.node[entry]])]
        leading = came[log.node[entry]]
        for dart in darts:
            if is_goal(dart):
                return [*leading, dart]
        for dart in darts:
            other = log.beyond(dart)
            if other != OPEN and log.node[other] not in came:
                came[log.node[other]] = [*leading, dart]
                queue.append(other)
    raise AssertionError("the folded log is connected")
