"""Planar drawings of maps, by Tutte's method.

The drawing is triangulated; the triangulation is called the *mesh*.  Tutte's method puts each point
of the mesh inside the outer ring in the middle of its neighbours.
"""

from cmath import exp
from collections.abc import Sequence
from itertools import pairwise
from math import inf, tau

from msgspec import Struct

from allworlds.maps.combinatorial import CombinatorialMap, Dart, cycles

TRIES = 12
"""The number of orders of the edges that are tried for a drawing with few crossings."""


class PlanarMap(Struct, frozen=True):
    """The drawing of a map, as a planar map with added vertices at crossings and bends.

    Attributes:
        sigma, alpha: the permutations of the darts of the drawing.  The darts of the map have the
            first numbers, the same as in the map, and sigma takes them as in the map.  The next
            numbers are those of the crossings: each crossing has four darts with successive
            numbers, clockwise, so opposite darts differ by 2.  The last numbers are those of the
            bends, with two darts each.  Only loops without crossings have bends, so that they are
            drawn rounder.
        own: the number of darts of the map.
        unbent: the number of darts of the map and of the crossings together.
    """

    sigma: tuple[Dart, ...]
    alpha: tuple[Dart, ...]
    own: int
    unbent: int

    def way(self, dart: Dart) -> list[Dart]:
        """The darts along one edge of the drawn map, from ``dart`` on.

        There are two darts for each part of the edge between crossings or bends.
        """
        way = [dart, self.alpha[dart]]
        while way[-1] >= self.own:
            after = self.sigma[way[-1]]
            opposite = after if self.sigma[after] == way[-1] else self.sigma[after]
            way += [opposite, self.alpha[opposite]]
        return way


def planar(map_: CombinatorialMap) -> PlanarMap:
    """A drawing of the map in the plane; it has no crossing if and only if the genus is 0.

    Cost: O(TRIES m c); c is the number of crossings and edges together.
    """
    edges = map_.edges
    tries = min(len(edges), TRIES) if map_.genus else 1
    orders = (edges[i:] + edges[:i] for i in range(tries))
    return min((_drawn(map_, order) for order in orders), key=lambda drawn: drawn.unbent)


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
    unbent = len(plane.sigma)
    for a, b in order:
        if map_.vertex_of[a] == map_.vertex_of[b] and plane.alpha[a] == b:
            plane.bend(a, b)
    darts = range(len(plane.sigma))
    sigma = tuple(plane.sigma[d] for d in darts)
    return PlanarMap(sigma, tuple(plane.alpha[d] for d in darts), len(map_.sigma), unbent)


def _spanning_tree(
    map_: CombinatorialMap, order: Sequence[tuple[Dart, Dart]]
) -> list[tuple[Dart, Dart]]:
    """The edges of a spanning tree, in an order in which each edge touches an earlier edge.

    ``order`` holds all edges of the map; of several edges that could be next in the tree, the first
    in ``order`` is taken.  For a map with one vertex the result is the first edge in ``order``,
    since a drawing begins with an edge.
    """
    owner = map_.vertex_of
    joined, tree = {owner[order[0][0]]}, []
    while len(joined) < map_.vertex_count:
        edge = next(e for e in order if (owner[e[0]] in joined) != (owner[e[1]] in joined))
        joined |= {owner[dart] for dart in edge}
        tree.append(edge)
    return tree or [order[0]]


class _Plane:
    """The drawing made so far, as a planar map.

    Its darts are those darts of the map that are drawn, and four for each crossing.
    """

    def __init__(self, map_: CombinatorialMap) -> None:
        self.map = map_
        self.sigma: dict[Dart, Dart] = {}
        self.alpha: dict[Dart, Dart] = {}
        self.next = len(map_.sigma)

    def route(self, a: Dart, b: Dart) -> list[Dart]:
        """The darts that a new edge from dart a to dart b must cross, on a shortest way.

        The dart a will be drawn between two drawn darts of its vertex; there the way begins.  In
        the same way it ends at b.  If the way crosses an edge, the result has one of its two darts:
        the one that has the way before the crossing to its left, and the way after the crossing to
        its right.
        """
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
        """Draw the edge from dart a to dart b.

        ``crossed`` holds the darts that the edge crosses, in their order, as :meth:`route` returns
        them.
        """
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

    def bend(self, a: Dart, b: Dart) -> None:
        """Put a bend into the edge of the darts a and b: a vertex of degree 2 in its middle."""
        near, far = self.next, self.next + 1
        self.next += 2
        self.sigma |= {near: far, far: near}
        self._link(a, near)
        self._link(far, b)

    def _link(self, a: Dart, b: Dart) -> None:
        self.alpha[a], self.alpha[b] = b, a

    def _put(self, dart: Dart) -> None:
        before = self._before(dart)
        self.sigma[dart] = dart if before is None else self.sigma[before]
        if before is not None:
            self.sigma[before] = dart

    def _before(self, dart: Dart) -> Dart | None:
        """The next drawn dart counterclockwise; None if no other dart of the vertex is drawn."""
        around = (self.map.turn(dart, -k) for k in range(1, self.map.degree_at[dart]))
        return next((d for d in around if d in self.sigma), None)

    def _face_at(self, dart: Dart, face_of: dict[Dart, int]) -> int:
        before = self._before(dart)
        assert before is not None
        return face_of[self.sigma[before]]

    def _faces(self) -> tuple[dict[Dart, int], list[list[Dart]]]:
        """The number of the face to the left of each dart, and the darts of each face."""
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


SWEEPS = 150
"""The number of sweeps that improve a drawing; a sweep moves every point once."""

MOST_SWEEPS = 100_000
"""The largest number of sweeps that are made until no triangle is turned over; far fewer are
needed."""

FURTHER = 1.8

ROOM = 4.0
"""Twice the wanted area of triangles at a vertex, which gives room for the numbers of its darts."""

RING = 0.05
"""The weight of triangles at the ring of points round the drawing; these triangles may be flat."""


class Mesh(Struct, frozen=True):
    """The triangulation of a planar drawing.

    The points of the mesh are numbered.  They come in seven groups, in this order:

    - for each dart a point on the dart;
    - for each dart a point just clockwise of the dart, at its vertex;
    - for each dart a point just anticlockwise of the dart, at its vertex;
    - for each dart a point to the left of the dart's edge;
    - for each vertex a point, in the order of sigma's cycles;
    - for each face but the outer one a point;
    - the points of the ring round the drawing.

    Attributes:
        links: the neighbours of each point inside the ring, clockwise.
        rooms: for each point inside the ring a list with a number for each of its neighbours.  The
            point, this neighbour and the neighbour before it are the corners of a triangle; the
            number is twice the area that the triangle should have.
        first_vertex: the number of the first vertex's point.
        ring: the numbers of the points of the ring, clockwise.
    """

    links: list[list[int]]
    rooms: list[list[float]]
    first_vertex: int
    ring: range


def mesh(drawn: PlanarMap) -> Mesh:
    """The triangulation of a planar map, with the longest face outside.

    Bends do not count for the length of a face.
    """
    sigma, alpha, size = drawn.sigma, drawn.alpha, len(drawn.sigma)
    vertices = cycles(sigma)
    after, before, left, first_vertex = size, 2 * size, 3 * size, 4 * size
    vertex_of = {d: first_vertex + i for i, vertex in enumerate(vertices) for d in vertex}
    faces = sorted(
        cycles([sigma[e] for e in alpha]), key=lambda face: sum(d < drawn.unbent for d in face)
    )
    first_face = first_vertex + len(vertices)
    face_of = {d: first_face + i for i, face in enumerate(faces) for d in face}
    previous = {e: d for d, e in enumerate(sigma)}
    links = [
        [vertex_of[d], before + d, left + d, e, left + e, after + d] for d, e in enumerate(alpha)
    ]
    links += [
        [vertex_of[d], d, left + alpha[d], face_of[sigma[d]], before + sigma[d]]
        for d in range(size)
    ]
    links += [[vertex_of[d], after + previous[d], face_of[d], left + d, d] for d in range(size)]
    links += [[d, before + d, face_of[d], after + e, e] for d, e in enumerate(alpha)]
    links += [[p for d in v for p in (d, after + d, before + sigma[d])] for v in vertices]
    links += [
        [p for d in reversed(face) for p in (after + alpha[d], left + d, before + d)]
        for face in faces
    ]
    # Seen from the longest face the others are outside; so its circle is clockwise the other way.
    edge = links.pop()[::-1]
    ring = range(len(links), len(links) + len(edge))
    for i, point in enumerate(edge):
        index = links[point].index(ring.start)
        links[point][index : index + 1] = [ring[i - 1], ring[i]]
    own = {first_vertex + i for i, vertex in enumerate(vertices) if vertex[0] < drawn.own}
    rooms = [
        [ROOM if own & {i, a, b} else 1.0 for a, b in pairwise([link[-1], *link])]
        for i, link in enumerate(links)
    ]
    return Mesh(links, rooms, first_vertex, ring)


def coordinates(net: Mesh) -> list[complex]:
    """The coordinates of each point, such that no triangle is turned over.

    The coordinate y grows downwards, so clockwise is the sense of growing angles.  The unit is
    about the side of a triangle.

    A sweep moves every point inside the ring once.  First, sweeps put each point in the middle of
    its neighbours, until no triangle is turned over; they stop after :data:`MOST_SWEEPS` in any
    case, but far fewer are needed.  Then :data:`SWEEPS` sweeps bring the triangles nearer to their
    wanted areas and to equal sides, see :func:`_move`.

    Cost: linear in the points for each sweep.
    """
    links, count = net.links, len(net.ring)
    radius = 0.6 * len(links) ** 0.5 + 2
    points = [0j] * len(links) + [radius * exp(1j * tau * i / count) for i in range(count)]
    for sweep in range(MOST_SWEEPS):
        for i, link in enumerate(links):
            points[i] = sum(points[j] for j in link) / len(link)
        if sweep % 20 == 0 and all(
            _strain(points[i], i, net, points)[0] < inf for i in range(len(links))
        ):
            break
    for _ in range(SWEEPS):
        for i in range(len(links)):
            _move(i, net, points)
    return points


def _move(i: int, net: Mesh, points: list[complex]) -> None:
    """Move the point i so that the strain of the triangles around it, see :func:`_strain`, falls.

    ``points`` holds the coordinates of all points, and is changed in place.  If no step that is
    tried lowers the strain, the point stays.
    """
    here = points[i]
    strain, step = _strain(here, i, net, points)
    step *= FURTHER
    for _ in range(6):
        if _strain(here + step, i, net, points)[0] < strain:
            points[i] = here + step
            return
        step /= 2


def _strain(centre: complex, i: int, net: Mesh, points: Sequence[complex]) -> tuple[float, complex]:
    """The strain of the triangles around point i, if it is at ``centre``; and a step of point i.

    The step, a complex number, has a direction in which the strain falls, but it may be too long.
    The strain is the sum of the strains of the triangles.  For one triangle, let A be twice its
    area, R twice the area that it should have, and S the sum of the squares of its sides.  Its
    strain is S/A + R/A + A/R; for a triangle with a point of the ring it is :data:`RING` / A.  If a
    triangle is turned over, or flat, the strain is infinite, and the step is 0.
    """
    link, ring = net.links[i], net.ring.start
    strain, slope, bend = 0.0, 0j, 0.0
    last = link[-1]
    ray = points[last] - centre
    for j, room in zip(link, net.rooms[i], strict=True):
        other = points[j] - centre
        area = ray.real * other.imag - ray.imag * other.real
        if area <= 0:
            return inf, 0j
        side = other - ray
        squares = abs(ray) ** 2 + abs(other) ** 2 + abs(side) ** 2
        if j >= ring or last >= ring:
            strain += RING / area
            slope -= RING / area**2 * 1j * side
            bend += 2 * RING * abs(side) ** 2 / area**3
        else:
            wide = squares + room
            strain += wide / area + area / room
            slope -= 2 * (ray + other) / area + (wide / area**2 - 1 / room) * 1j * side
            bend += 4 / area + 2 * wide * abs(side) ** 2 / area**3
        last, ray = j, other
    return strain, -slope / bend
