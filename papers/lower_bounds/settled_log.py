"""The folded log whose nodes can be settled, and in which two darts can be supposed to be one.

Some nodes are *settled*: proved to be pairwise different vertices.  They are never merged into
others, so their darts keep their numbers.
"""

from __future__ import annotations

from allworlds import Percept
from allworlds.claims import FoldedLog

OPEN = -1
"""The other end of a dart that the robot has not gone through."""


class SettledLog(FoldedLog):
    """A folded log.

    Attributes:
        settled: for each node whether it is settled.
    """

    def __init__(self, first: Percept) -> None:
        self.settled: list[bool] = []
        super().__init__(first)
        self.settled[0] = True

    def _add_node(self, degree: int) -> int:
        """Add a node; return its first dart."""
        self.settled.append(False)
        return super()._add_node(degree)

    def _differ(self, v: int, w: int) -> bool:
        """Whether two nodes of the same degree are known to be two vertices."""
        return self.settled[v] and self.settled[w]

    def _stays(self, v: int, w: int) -> bool:
        """Whether the first of two nodes stays when they are merged: the settled or older one."""
        return (self.settled[v], -v) > (self.settled[w], -w)

    def contradicts(self, one: int, another: int) -> bool:
        """Whether two canonical darts cannot be one: all consequences are checked.

        A consequence is a contradiction if two degrees differ, if an unmarked node is v0, if two
        settled nodes are one, or if a node is itself with an offset.  The log is not changed.

        Cost: the nodes that would be merged, with their known darts.
        """
        return _Supposed(self).contradicts(one, another)


class _Supposed:
    """Nodes merged on trial, over a log that stays as it is."""

    def __init__(self, log: SettledLog) -> None:
        self._log = log
        self._stands: dict[int, int] = {}
        self._leads: dict[int, dict[int, int]] = {}

    def _found(self, dart: int) -> int:
        """The dart that a canonical dart of the log is now."""
        node, base, stands = self._log.node, self._log.base, self._stands
        v = node[dart]
        while v in stands:
            dart = self._log.turn(stands[v], dart - base[v])
            v = node[dart]
        return dart

    def contradicts(self, one: int, another: int) -> bool:
        """Whether two darts cannot be one; see :meth:`SettledLog.contradicts`."""
        log, stands = self._log, self._stands
        node, base, degree, settled = log.node, log.base, log.degree, log.settled
        # Two darts to be made one, and whether each is what an edge of the two leads to: then
        # there is nothing new in where they lead themselves.
        equal = [(one, another, False)]
        while equal:
            a, b, crossed = equal.pop()
            v, w = node[a], node[b]
            if v in stands or w in stands:
                a, b = self._found(a), self._found(b)
                v, w = node[a], node[b]
            if v == w and a == b:
                continue
            if v == w or degree[v] != degree[w]:
                return True
            if (settled[w], -w) > (settled[v], -v):
                a, b, v, w = b, a, w, v
            if v == 0 or settled[w]:
                return True
            stands[w] = base[v] + (a - base[v] + base[w] - b) % degree[v]
            if self._follow(a, b, b if crossed else OPEN, equal):
                return True
        return False

    def _follow(self, a: int, b: int, done: int, equal: list[tuple[int, int, bool]]) -> bool:
        """Transfer the known darts of b's node to a's.

        Returns:
            True for a contradiction; else the consequences have been added to ``equal``.
        """
        log, leads = self._log, self._leads
        node, degree, known, beyond = log.node, log.degree, log.known, log.beyond
        v, w = node[a], node[b]
        first, size = log.base[v], degree[v]
        shift = a - first - b
        gained = leads.get(v, _NOTHING)
        followed = [(x, beyond(x)) for x in known[w] if x != done]
        if w in leads:
            followed += leads.pop(w).items()
        for x, target in followed:
            y = first + (x + shift) % size
            other = beyond(y)
            if other == OPEN:
                other = gained.get(y, OPEN)
            if other == OPEN:
                gained = leads.setdefault(v, {})
                gained[y] = target
                continue
            t, u = node[target], node[other]
            untouched = t not in leads and t not in self._stands
            if len(known[t]) == 1 and untouched and not log.settled[t]:
                # Nothing is known of that node but its way back: it adds nothing.
                if degree[t] != degree[u] or u == 0:
                    return True
                continue
            equal.append((target, other, True))
        return False


_NOTHING: dict[int, int] = {}
