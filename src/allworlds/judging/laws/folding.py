"""The folded log: everything that a directional log proves, without trust in any explorer.

A directional log is the log of a run under the directional lighthouse.  A *node* is a copy of a
vertex; at first every arrival through an open dart makes a new node.  At v0 a robot knows its
vertex and its dart, so the node of an arrival at v0 is merged with v0; the bearing says which dart
is merged with which.  If a dart then leads to two nodes, these two are merged, too.  The result is
a part of every world that agrees with the log.  A result without an open dart *is* the world.
"""

from msgspec import Struct

from allworlds.protocol.actions import Move, Percept, Transcript


class Contradiction(ValueError):
    """Raised for a log that no run in a world with a directional lighthouse can have."""


class Folded(Struct, frozen=True):
    """The folded log: the part of the map that a log proves.

    Attributes:
        sigma, alpha: the known part of the map; the darts of v0 come first, from the dart that the
            robot faced at the start, then those of the other vertices in the order of discovery;
            ``alpha[d] == d`` marks an open dart.
        here: the robot's dart at the end of the log.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    here: int

    @property
    def open_darts(self) -> int:
        """The number of darts whose other end the log leaves open."""
        return sum(d == e for d, e in enumerate(self.alpha))


def fold(transcript: Transcript) -> Folded:
    """Fold the log of a run: return the part of the map that the log proves.

    ``transcript`` is the log: the actions and percepts of a run under the directional lighthouse.

    Raises:
        Contradiction: if no world with a directional lighthouse has this log.

    Cost: almost linear in the number of steps times the largest degree.
    """
    folding = _Folding(transcript.first)
    dart = 0
    for action, percept in transcript.steps:
        if type(action) is Move:
            dart = folding.walk(dart, action.k, percept)
    return folding.result(dart)


class _Folding:
    """Nodes in a union-find forest: a forest of trees, each of which holds merged nodes.

    The root of a tree stands for all nodes of the tree.  Node v owns the darts
    ``first[v] .. first[v] + degree[v] - 1``.  If ``parent[v] = w``, dart i of v is merged with dart
    ``i + shift[v]`` (modulo the degree) of w.  The parent of a root is the root itself.
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
        """Note a motion: the robot leaves by ``sigma^k(dart)``, and then senses ``percept``.

        ``dart`` is the robot's dart before the motion.  Return the dart of arrival.  Both darts
        are darts of root nodes.

        Raises:
            Contradiction: if no world agrees with the log so far and with this percept.
        """
        _check(percept)
        v = self.node[dart]
        leaving = self.first[v] + (dart - self.first[v] + k) % self.degree[v]
        arrived = self.link[leaving]
        if arrived == -1:
            arrived = self._add(percept.degree)
            self.link[leaving], self.link[arrived] = arrived, leaving
        if percept.marks:
            assert self.home.bearing is not None
            assert percept.bearing is not None
            self._merge(arrived, (self.home.bearing - percept.bearing) % self.home.degree)
        arrived = self._root(arrived)
        v = self.node[arrived]
        if not percept.marks:
            self.seen_unmarked[v] = True
        if self.seen_unmarked[0]:
            raise Contradiction("the marked vertex has been seen without its mark")
        if self.degree[v] != percept.degree:
            raise Contradiction(f"a vertex of degree {self.degree[v]} seen as {percept}")
        return arrived

    def result(self, dart: int) -> Folded:
        """The folded log, made of the root nodes; the robot is at ``dart``.

        Raises:
            Contradiction: if a dart would be the other end of its own edge.
        """
        number: dict[int, int] = {}
        sigma: list[int] = []
        for v, (first, degree) in enumerate(zip(self.first, self.degree, strict=True)):
            if self.parent[v] == v:
                start = len(sigma)
                sigma.extend(range(start + 1, start + degree))
                sigma.append(start)
                number.update((first + i, start + i) for i in range(degree))
        alpha = []
        for d, own in number.items():
            target = self.link[d]
            end = own if target == -1 else number[self._root(target)]
            if end == own and target != -1:
                raise Contradiction("a dart leads back to itself")
            alpha.append(end)
        return Folded(tuple(sigma), tuple(alpha), number[self._root(dart)])

    def _add(self, degree: int) -> int:
        """Add a new node with ``degree`` darts; return the first dart of the node."""
        start, v = len(self.node), len(self.first)
        self.node.extend([v] * degree)
        self.link.extend([-1] * degree)
        self.first.append(start)
        self.degree.append(degree)
        self.parent.append(v)
        self.shift.append(0)
        self.seen_unmarked.append(False)
        return start

    def _root(self, dart: int) -> int:
        """The dart of a root node with which ``dart`` was merged.

        The result is ``dart`` itself if its node is a root.
        """
        v = self.node[dart]
        while self.parent[v] != v:
            w = self.parent[v]
            dart = self.first[w] + (dart - self.first[v] + self.shift[v]) % self.degree[v]
            v = w
        return dart

    def _merge(self, a: int, b: int) -> None:
        """Merge dart ``a`` with dart ``b``, and thereby the node of ``a`` with the node of ``b``.

        If two darts that are merged both have a known other end, these two ends are merged, too.

        Raises:
            Contradiction: if two darts of one node, or nodes of different degrees, would be merged.
        """
        todo = [(a, b)]
        while todo:
            a, b = todo.pop()
            if (a := self._root(a)) == (b := self._root(b)):
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
            for x in range(self.first[v], self.first[v] + degree):
                if self.link[x] == -1:
                    continue
                y = self._root(x)
                if self.link[y] == -1:
                    self.link[y] = self.link[x]
                else:
                    todo.append((self.link[x], self.link[y]))


def _check(percept: Percept) -> None:
    """Raise Contradiction if a robot cannot sense ``percept`` under the directional lighthouse.

    The degree must be positive.  A percept with a mark has a bearing below the degree; a percept
    without a mark has no bearing.
    """
    degree, bearing = percept.degree, percept.bearing
    sensed = bearing is not None and 0 <= bearing < degree
    legal = sensed if percept.marks else bearing is None
    if degree < 1 or not legal:
        raise Contradiction(f"no directional lighthouse is sensed like this: {percept}")
