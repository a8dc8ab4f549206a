"""The enumeration of all rooted maps of a class, one by one, each exactly once.

A map is glued together from its root.  The darts are numbered in the order in which they are made.
Each step is a *decision*: the oldest open dart is glued either to another open dart or to the first
dart of a new vertex of degree d; the other darts of this vertex become open.  The *history* of a
map is the sequence of its decisions.  Each rooted map has exactly one history, so no map is made
twice.

In the classes ``maps`` and ``planar`` each history can be finished, because a decision is refused
in two cases: if it leaves no dart open, although darts must still be made; or if the bounds on
edges and vertices leave too few new vertices.  In the plane a dart is glued only to a dart of the
same face, and each face with an odd number of open darts needs a new vertex of its own.

In simple classes all open darts of a vertex must lead to different vertices that are not yet its
neighbours.  A decision is refused if there are too few such vertices.  This test does not find all
dead ends, so a few histories end without a map.  Under a condition on maps, histories can also end
without a map.  For a condition on the faces of a map the dual is glued together instead of the map,
because the condition is one on the vertices of the dual.

An unfinished map is called a *gluing*.  Its *faces* are those of the edges so far, each with the
open darts that stand in the face.
"""

from collections.abc import Iterator, Sequence
from typing import TypeAlias

from allworlds.maps.classes import OPEN, Condition, MapClass, narrowing
from allworlds.maps.combinatorial import CombinatorialMap, Dart

Decision: TypeAlias = int
"""A decision about the oldest open dart.  ``z >= 0`` glues the dart to the open dart ``z``;
``-d`` glues the dart to a new vertex of degree d.  The first decision is ``-d`` for the vertex of
the root, of degree d."""


class Gluing:
    """An unfinished map that grows by decisions.

    Args:
        edges: m, the number of edges of the finished map.
        map_class: the class of the finished map.
        vertices: the largest number of vertices of the finished map; None for any number.
        where: a condition by which unfinished maps are given up; None for no condition.

    Attributes:
        edges: m, the number of edges of the finished map.
        limit: the largest number of vertices that the gluing may get.
        alpha: for each dart so far the dart to which it is glued; OPEN for an open dart.
        vertex: for each dart its vertex.
        degrees: the degree of each vertex.
        faces: for each face with open darts, these open darts in their order round the face; in
            classes that are not planar, a single list of all open darts.
        newest: a dart of the edge that was glued last; OPEN if there is no edge.
    """

    def __init__(
        self,
        edges: int,
        map_class: MapClass,
        vertices: int | None = None,
        where: Condition | None = None,
    ) -> None:
        self._where = narrowing(where)
        self._dual = any(condition.dual for condition in self._where)
        self.edges = edges
        self.limit = edges + 1
        if vertices is not None and not self._dual:
            self.limit = min(self.limit, vertices)
        self.planar = map_class.planar
        self.simple = map_class.simple and not self._dual
        self.alpha: list[Dart] = []
        self.vertex: list[int] = []
        self.degrees: list[int] = []
        self.neighbours: list[int] = []
        self.faces: list[list[Dart]] = []
        self.newest = OPEN

    @property
    def owed(self) -> int:
        """The number of darts that must still be made."""
        return 2 * self.edges - len(self.alpha)

    @property
    def finished(self) -> bool:
        """Whether the gluing is a complete map: no dart is open, or must still be made."""
        return bool(self.degrees) and not self.faces

    def successors(self) -> "Iterator[tuple[Decision, Gluing]]":
        """Yield the legal decisions about the oldest open dart, each with the gluing after it.

        The order is fixed: first the decisions that glue the dart to an open dart, ascending; then
        those that make a new vertex, by ascending degrees.  Each of the gluings can be finished,
        except for a few in simple classes or under a condition on maps.

        Cost: O(m) for each gluing.
        """
        if not self.degrees:
            most = self.edges if self.simple else 2 * self.edges
            decisions: list[Decision] = [-degree for degree in range(1, most + 1)]
        else:
            y, face = self._oldest()
            decisions = sorted(z for z in face if z != y and not self._excluded(y, z))
            if len(self.degrees) < self.limit:
                decisions += [-degree for degree in range(1, self.owed + 1)]
        for decision in decisions:
            after = self._fork()
            after.apply(decision)
            if after._can_be_finished() and all(c.may_begin(after) for c in self._where):  # noqa: SLF001  # its own kind
                yield decision, after

    def apply(self, decision: Decision) -> None:
        """Glue the oldest open dart as ``decision`` says; the first decision makes a vertex alone.

        Cost: O(m).
        """
        if not self.degrees:
            self._new_vertex(-decision)
            self.faces = [list(range(-decision))]
            return
        y, face = self._oldest()
        rest = [other for other in self.faces if other is not face]
        i = face.index(y)
        around = face[i + 1 :] + face[:i]
        if decision < 0:
            first = self._new_vertex(-decision)
            self._join(y, first)
            parts = [list(range(first + 1, first - decision)) + around]
        else:
            self._join(y, decision)
            j = around.index(decision)
            between, beyond = around[:j], around[j + 1 :]
            parts = [between, beyond] if self.planar else [between + beyond]
        self.faces = rest + [part for part in parts if part]

    def _oldest(self) -> tuple[Dart, list[Dart]]:
        """The oldest open dart, and the member of :attr:`faces` that holds this dart."""
        face = min(self.faces, key=min)
        return min(face), face

    def finish(self) -> CombinatorialMap:
        """The finished map; its root is dart 0.

        The darts of a vertex are consecutive.  If the dual was glued together, the darts of a face
        are consecutive instead.
        """
        sigma = list(range(1, 2 * self.edges + 1))
        first = 0
        for degree in self.degrees:
            sigma[first + degree - 1] = first
            first += degree
        made = CombinatorialMap.trusted(sigma, self.alpha)
        return made.dual() if self._dual else made

    def _fork(self) -> "Gluing":
        twin = object.__new__(Gluing)
        vars(twin).update(vars(self))
        twin.alpha, twin.vertex = self.alpha[:], self.vertex[:]
        twin.degrees, twin.neighbours = self.degrees[:], self.neighbours[:]
        return twin

    def _new_vertex(self, degree: int) -> Dart:
        first = len(self.alpha)
        self.alpha.extend([OPEN] * degree)
        self.vertex.extend([len(self.degrees)] * degree)
        self.degrees.append(degree)
        self.neighbours.append(0)
        return first

    def _join(self, a: Dart, b: Dart) -> None:
        self.alpha[a], self.alpha[b] = b, a
        self.newest = a
        u, v = self.vertex[a], self.vertex[b]
        self.neighbours[u] |= 1 << v
        self.neighbours[v] |= 1 << u

    def _excluded(self, a: Dart, b: Dart) -> bool:
        """Whether gluing ``a`` to ``b`` is illegal: a loop or a parallel edge in a simple class."""
        u, v = self.vertex[a], self.vertex[b]
        return self.simple and (u == v or bool(self.neighbours[u] >> v & 1))

    def _can_be_finished(self) -> bool:
        owed = self.owed
        if not self.faces:
            return owed == 0
        if owed and len(self.degrees) == self.limit:
            return False
        if self.planar:
            # Each face with an odd number of open darts needs a new vertex of its own.
            new = min(owed, self.limit - len(self.degrees))
            if sum(len(face) % 2 for face in self.faces) > new:
                return False
        return not self.simple or self._enough_partners()

    def _enough_partners(self) -> bool:
        open_darts = [0] * len(self.degrees)
        for d, e in enumerate(self.alpha):
            if e == OPEN:
                open_darts[self.vertex[d]] += 1
        new = min(self.owed, self.limit - len(self.degrees))
        waiting = [v for v, count in enumerate(open_darts) if count]
        for v in waiting:
            partners = sum(u != v and not self.neighbours[v] >> u & 1 for u in waiting)
            if open_darts[v] > partners + new:
                return False
        return True


def rooted_maps(
    edges: int,
    map_class: MapClass = MapClass.MAPS,
    vertices: int | None = None,
    prefix: Sequence[Decision] = (),
    where: Condition | None = None,
) -> Iterator[CombinatorialMap]:
    """Yield every map of the class with exactly ``edges`` edges, rooted at dart 0, once each.

    Args:
        edges: m >= 1.
        map_class: the class.
        vertices: the largest number of vertices; None for any number.
        prefix: the first decisions of a history (:func:`prefixes`); only maps whose history begins
            with these decisions are yielded; by default all maps.
        where: a condition; only maps that meet the condition are yielded.  None for no condition.

    The maps come in a fixed order.  Cost: constant memory.
    """
    gluing = Gluing(edges, map_class, vertices, where)
    for decision in prefix:
        gluing.apply(decision)
    every = (finished.finish() for _, finished in _grown(gluing, ()))
    if where is None:
        yield from every
        return
    most = edges + 1 if vertices is None else vertices
    for map_ in every:
        if map_class.includes(map_) and map_.vertex_count <= most and where.holds(map_):
            yield map_


def _grown(
    gluing: Gluing, history: tuple[Decision, ...], depth: int | None = None
) -> Iterator[tuple[tuple[Decision, ...], Gluing]]:
    """Yield the gluings to which ``gluing`` grows, each with its history.

    A gluing is yielded as soon as it is finished or has a history of ``depth`` decisions; if
    ``depth`` is None, only finished gluings are yielded.  ``history`` holds the decisions that have
    led to ``gluing``.
    """
    if gluing.finished or len(history) == depth:
        yield history, gluing
        return
    for decision, after in gluing.successors():
        yield from _grown(after, (*history, decision), depth)


def history(map_: CombinatorialMap) -> tuple[Decision, ...]:
    """The decisions that glue the map ``map_`` together from its dart 0.  Cost: O(m)."""
    order, decisions = list[Dart](), list[Decision]()
    number: dict[Dart, Dart] = {}

    def met(dart: Dart) -> None:
        before = len(order)
        while dart not in number:
            number[dart] = len(order)
            order.append(dart)
            dart = map_.sigma[dart]
        decisions.append(before - len(order))

    met(0)
    for dart in order:
        other = map_.alpha[dart]
        if other not in number:
            met(other)
        elif number[other] > number[dart]:
            decisions.append(number[other])
    return tuple(decisions)


FINGERPRINTS = 1 << 62
"""The number of fingerprints; their sums are taken modulo this number."""


def fingerprint(map_: CombinatorialMap) -> int:
    """A number that stands for a map rooted at dart 0, computed from its :func:`history`.

    Two different sets of maps nearly always have different sums of fingerprints, modulo
    :data:`FINGERPRINTS`.  So if an enumeration has the right sum, it has almost certainly met each
    map exactly once.  Cost: O(m).
    """
    code = 0
    for decision in history(map_):
        code = (code ^ decision) * 0x1E3779B97F4A7C15 % FINGERPRINTS
        code ^= code >> 31
    return code


def prefixes(
    edges: int,
    map_class: MapClass = MapClass.MAPS,
    vertices: int | None = None,
    depth: int = 2,
    where: Condition | None = None,
) -> Iterator[tuple[Decision, ...]]:
    """Yield the beginnings of the histories of all maps of the class, each beginning once.

    A beginning is the first ``depth`` decisions of a history, or a whole history with fewer
    decisions.  The maps have exactly ``edges`` edges, and at most ``vertices`` vertices (None: any
    number).  If the condition ``where`` is given, only maps that meet it are meant.  The history of
    each of these maps begins with exactly one of the results.  A few results may begin no such
    history, because some dead ends are not found early.
    """
    for history, _ in _grown(Gluing(edges, map_class, vertices, where), (), depth):
        yield history
