"""Planar drawings of maps of any genus: where edges must cross, the crossing becomes a vertex.

A spanning tree is drawn first, then every edge that crosses nothing, then the others, each by
a way through the faces that crosses as few edges as possible.  The darts of a vertex keep their
cyclic order all the while, whatever is drawn and whatever is not yet.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from allworlds.maps import CombinatorialMap, Dart

TRIES = 12
"""In so many orders of the edges it is tried; the drawing with the fewest crossings is kept."""


class PlanarMap(Struct, frozen=True):
    """A planar map that draws another one.

    Attributes:
        sigma, alpha: the permutations.  The darts of the drawn map come first and keep their
            names; round its vertices sigma is as it was.  The others come in fours, clockwise
            round a crossing, so each stands opposite to the one after the next.
        own: the number of darts of the drawn map.
    """

    sigma: tuple[Dart, ...]
    alpha: tuple[Dart, ...]
    own: int

    @property
    def crossings(self) -> int:
        """The number of crossings of edges."""
        return (len(self.sigma) - self.own) // 4

    def way(self, dart: Dart) -> list[Dart]:
        """The darts along the edge that begins with the dart, both ends of each piece."""
        way = [dart, self.alpha[dart]]
        while way[-1] >= self.own:
            opposite = self.sigma[self.sigma[way[-1]]]
            way += [opposite, self.alpha[opposite]]
        return way


def planar(map_: CombinatorialMap) -> PlanarMap:
    """The map drawn in the plane; without a crossing if and only if its genus is 0.

    Cost: O(TRIES m c), for c crossings and edges.
    """
    return drawings(map_)[0]


def drawings(map_: CombinatorialMap) -> list[PlanarMap]:
    """The different drawings with the fewest crossings found, that of :func:`planar` first."""
    edges = map_.edges
    orders = [edges[i:] + edges[:i] for i in range(min(len(edges), TRIES))]
    if map_.genus == 0:
        del orders[1:]
    found = [_drawn(map_, order) for order in orders]
    least = min(drawn.crossings for drawn in found)
    return [*dict.fromkeys(drawn for drawn in found if drawn.crossings == least)]


def _drawn(map_: CombinatorialMap, order: Sequence[tuple[Dart, Dart]]) -> PlanarMap:
    plane = _Plane(map_)
    waiting = list(order)
    for a, b in _spanning_tree(map_, order):
        plane.join(a, b, [])
        waiting.remove((a, b))
    crossing = []
    for a, b in waiting:
        if plane.route(a, b):
            crossing.append((a, b))
        else:
            plane.join(a, b, [])
    for a, b in crossing:
        plane.join(a, b, plane.route(a, b))
    darts = range(len(plane.sigma))
    sigma = tuple(plane.sigma[d] for d in darts)
    return PlanarMap(sigma, tuple(plane.alpha[d] for d in darts), len(map_.sigma))


def _spanning_tree(
    map_: CombinatorialMap, order: Sequence[tuple[Dart, Dart]]
) -> list[tuple[Dart, Dart]]:
    """Edges that join all vertices without a cycle, each with a vertex that was joined before.

    In a map with one vertex it is the first edge, for something has to be drawn first.
    """
    owner = map_.vertex_of
    joined, tree = {owner[order[0][0]]}, []
    while len(joined) < map_.vertex_count:
        edge = next(e for e in order if (owner[e[0]] in joined) != (owner[e[1]] in joined))
        joined |= {owner[dart] for dart in edge}
        tree.append(edge)
    return tree or [order[0]]


class _Plane:
    """The part of the drawing made so far: some of the darts, and crossings, as a planar map."""

    def __init__(self, map_: CombinatorialMap) -> None:
        self.map = map_
        self.sigma: dict[Dart, Dart] = {}
        self.alpha: dict[Dart, Dart] = {}
        self.next = len(map_.sigma)

    def route(self, a: Dart, b: Dart) -> list[Dart]:
        """The darts to be crossed on a shortest way from a's corner to b's, from left to right."""
        face_of, darts = self._faces()
        goal = self._face_at(b, face_of)
        came: dict[int, list[Dart]] = {self._face_at(a, face_of): []}
        queue = list(came)
        for face in queue:
            if face == goal:
                break
            for dart in darts[face]:
                beyond = face_of[self.alpha[dart]]
                if beyond not in came:
                    came[beyond] = [*came[face], dart]
                    queue.append(beyond)
        return came[goal]

    def join(self, a: Dart, b: Dart, crossed: Sequence[Dart]) -> None:
        """Draw the edge of a and b across these darts."""
        self._put(a)
        end = a
        for dart in crossed:
            near, left, far, right = range(self.next, self.next + 4)
            self.next += 4
            self.sigma |= {near: left, left: far, far: right, right: near}
            self._link(far, self.alpha[dart])
            self._link(dart, near)
            self._link(end, left)
            end = right
        self._put(b)
        self._link(end, b)

    def _link(self, a: Dart, b: Dart) -> None:
        self.alpha[a], self.alpha[b] = b, a

    def _put(self, dart: Dart) -> None:
        before = self._before(dart)
        self.sigma[dart] = dart if before is None else self.sigma[before]
        if before is not None:
            self.sigma[before] = dart

    def _before(self, dart: Dart) -> Dart | None:
        """The last dart counterclockwise that is drawn already."""
        around = (self.map.turn(dart, -k) for k in range(1, self.map.degree_at[dart]))
        return next((d for d in around if d in self.sigma), None)

    def _face_at(self, dart: Dart, face_of: dict[Dart, int]) -> int:
        before = self._before(dart)
        assert before is not None
        return face_of[self.sigma[before]]

    def _faces(self) -> tuple[dict[Dart, int], list[list[Dart]]]:
        """The face to the left of each dart, and the darts of each face."""
        face_of: dict[Dart, int] = {}
        faces: list[list[Dart]] = []
        for first in self.sigma:
            if first in face_of:
                continue
            faces.append([])
            dart = first
            while dart not in face_of:
                face_of[dart] = len(faces) - 1
                faces[-1].append(dart)
                dart = self.sigma[self.alpha[dart]]
        return face_of, faces
