"""The folded log: all percepts of a robot with a directional lighthouse, as one map.

Every vertex that the robot stood on is a *node*.  Nodes are merged when an arrival at v0 shows that
they are one vertex, and with them all nodes that follow, because a dart leads to one dart only.  So
the folded log is a part of every world that agrees with the log: a hypothesis that contradicts the
folded log is refuted.
"""

from __future__ import annotations

from bisect import insort

from allworlds.protocol.actions import Percept

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
        node, base, stands = self.node, self.base, self.stands
        v = node[dart]
        if stands[v] == base[v]:
            return dart
        merged = []
        while stands[v] != base[v]:
            merged.append(v)
            v = node[stands[v]]
        for w in reversed(merged[:-1]):
            stands[w] = self.turn(stands[node[stands[w]]], stands[w] - base[node[stands[w]]])
        w = merged[0]
        return self.turn(stands[w], dart - base[w])

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
