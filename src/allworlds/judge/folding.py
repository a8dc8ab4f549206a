"""The log, folded: all that a directional log proves, without trusting any explorer.

Walk the log along a tree of fresh nodes.  A robot that arrives at v0 knows where it is and
how it is turned, so each such node is merged with v0, aligned by the bearing.  Merging goes
on where one dart would lead to two places.  What results is part of every world that agrees
with the log; without an open dart it *is* the world.
"""

from __future__ import annotations

from dataclasses import dataclass

from allworlds.protocol import Move, Percept, Transcript


class Contradiction(ValueError):
    """No world with a directional lighthouse has this log."""


@dataclass(frozen=True, slots=True)
class Folded:
    """The folded log.

    Attributes:
        sigma, alpha: its darts, those of v0 first from the dart faced at the start, then
            vertex by vertex in the order of discovery; ``alpha[d] == d`` is an open dart.
        here: the robot's dart at the end of the log.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    here: int

    @property
    def open_darts(self) -> int:
        """The number of darts of which the log does not tell where they lead."""
        return sum(d == e for d, e in enumerate(self.alpha))


def fold(transcript: Transcript) -> Folded:
    """Everything that the log proves.

    Raises:
        Contradiction: if no world has this log.

    Cost: almost linear in the steps times the largest degree.
    """
    folding = _Folding(transcript.first)
    dart = 0
    for action, percept in transcript.steps:
        if type(action) is Move:
            dart = folding.walk(dart, action.k, percept)
    return folding.result(dart)


class _Folding:
    """Nodes in a union-find forest; a merged node remembers by how much it is turned.

    Node v owns the darts ``first[v] .. first[v] + degree[v] - 1``.  If ``parent[v] = w``,
    dart i of v is dart ``i + shift[v]`` (modulo the degree) of w.
    """

    def __init__(self, first: Percept) -> None:
        if not first.marks:
            raise Contradiction("the first percept has no mark; only a directional log folds")
        _check(first)
        self.home = first
        self.node: list[int] = []
        self.link: list[int] = []
        self.first: list[int] = []
        self.degree: list[int] = []
        self.parent: list[int] = []
        self.shift: list[int] = []
        self.seen_unmarked: list[bool] = []
        self._add(first.degree)

    def walk(self, dart: int, k: int, percept: Percept) -> int:
        """Leave by ``sigma^k(dart)``, arrive with the percept: the dart arrived by."""
        _check(percept)
        dart = self._root(dart)
        first, degree = self._span(dart)
        leaving = first + (dart - first + k) % degree
        arrived = self.link[leaving]
        if arrived == -1:
            arrived = self._add(percept.degree)
            self.link[leaving], self.link[arrived] = arrived, leaving
        if percept.marks:
            assert self.home.bearing is not None
            assert percept.bearing is not None
            self._merge(arrived, (self.home.bearing - percept.bearing) % self.home.degree)
        else:
            self.seen_unmarked[self.node[self._root(arrived)]] = True
        if self.seen_unmarked[0]:
            raise Contradiction("the marked vertex has been seen without its mark")
        arrived = self._root(arrived)
        if self._span(arrived)[1] != percept.degree:
            raise Contradiction(f"a vertex of degree {self._span(arrived)[1]} seen as {percept}")
        return arrived

    def result(self, dart: int) -> Folded:
        """The roots' darts, renumbered."""
        nodes = [v for v in range(len(self.first)) if self.parent[v] == v]
        number: dict[int, int] = {}
        sigma: list[int] = []
        for v in nodes:
            start = len(sigma)
            for i in range(self.degree[v]):
                number[self.first[v] + i] = start + i
                sigma.append(start + (i + 1) % self.degree[v])
        alpha = []
        for d, own in number.items():
            target = self.link[d]
            alpha.append(own if target == -1 else number[self._root(target)])
            if target != -1 and alpha[-1] == own:
                raise Contradiction("a dart leads back to itself")
        return Folded(tuple(sigma), tuple(alpha), number[self._root(dart)])

    def _add(self, degree: int) -> int:
        """A fresh node; its first dart."""
        start, v = len(self.node), len(self.first)
        self.node.extend([v] * degree)
        self.link.extend([-1] * degree)
        self.first.append(start)
        self.degree.append(degree)
        self.parent.append(v)
        self.shift.append(0)
        self.seen_unmarked.append(False)
        return start

    def _span(self, dart: int) -> tuple[int, int]:
        v = self.node[dart]
        return self.first[v], self.degree[v]

    def _root(self, dart: int) -> int:
        """The dart of the root node that stands for this one."""
        v = self.node[dart]
        while self.parent[v] != v:
            w = self.parent[v]
            dart = self.first[w] + (dart - self.first[v] + self.shift[v]) % self.degree[v]
            v = w
        return dart

    def _merge(self, a: int, b: int) -> None:
        """Dart ``a`` is dart ``b``; so are their vertices, and where their darts lead to."""
        todo = [(a, b)]
        while todo:
            a, b = (self._root(dart) for dart in todo.pop())
            if a == b:
                continue
            v, w = self.node[a], self.node[b]
            degree = self.degree[v]
            if v == w or degree != self.degree[w]:
                raise Contradiction(f"two percepts of one vertex differ: darts {a} and {b}")
            if v < w:
                # The older node stays, so that v0 is always a root.
                a, b, v, w = b, a, w, v
            self.parent[v] = w
            self.seen_unmarked[w] |= self.seen_unmarked[v]
            self.shift[v] = ((b - self.first[w]) - (a - self.first[v])) % degree
            for i in range(degree):
                x = self.first[v] + i
                y = self._root(x)
                if self.link[x] == -1:
                    continue
                if self.link[y] == -1:
                    self.link[y] = self.link[x]
                else:
                    todo.append((self.link[x], self.link[y]))


def _check(percept: Percept) -> None:
    """A vertex has a dart, and exactly the marked one has a bearing, below its degree."""
    bearing = percept.bearing
    legal = bearing is None if not percept.marks else bearing in range(percept.degree)
    if percept.degree < 1 or not legal:
        raise Contradiction(f"no directional lighthouse is sensed like this: {percept}")
