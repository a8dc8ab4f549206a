"""A planar map in the plane: a triangulation with room round every dart, and where it lies.

Every vertex, dart and face is a point, and so are the two sides of each dart at its vertex and
the two sides of each edge.  These points form a triangulation without parallel edges, even
where the map has loops.  A ring round its outside is put on a circle and each other point
between its neighbours: then no triangle is turned over (W. T. Tutte, How to draw a graph,
1963), so that the darts leave a vertex in its cyclic order and no two edges cross.  Afterwards
the points move until the triangles are about alike, and still none is turned over.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from itertools import pairwise
from math import inf, tau

from msgspec import Struct

from allworlds.maps import cycles
from allworlds.reports.drawing.planar import PlanarMap

SWEEPS = 150
"""How often every point is moved."""

MOST_SWEEPS = 100_000
"""Far more than it takes until no triangle is turned over."""

FURTHER = 1.8

ROOM = 4.0
"""Of a triangle at a vertex: round it is to be room for the numbers of its darts."""

RING = 0.05
"""The weight of the triangles of the ring: it keeps others from meeting, and may be flat."""


class Mesh(Struct, frozen=True):
    """The triangulation.

    The points are the darts; then, for each dart, what is beside it: after it and before it at
    its vertex, and to the left of its edge; then the vertices, in the order of sigma's cycles;
    the faces; and the ring.

    Attributes:
        links: for each point within the ring its neighbours, clockwise.
        rooms: for each neighbour twice the area that is wanted for the triangle with it and the
            one before it.
        first_vertex: the point of the first vertex.
        ring: the points of the ring, clockwise.
    """

    links: list[list[int]]
    rooms: list[list[float]]
    first_vertex: int
    ring: range


def mesh(drawn: PlanarMap) -> Mesh:
    """The triangulation of a planar map with its longest face outside."""
    sigma, alpha, size = drawn.sigma, drawn.alpha, len(drawn.sigma)
    vertices = cycles(sigma)
    after, before, left, first_vertex = size, 2 * size, 3 * size, 4 * size
    vertex_of = {d: first_vertex + i for i, vertex in enumerate(vertices) for d in vertex}
    faces = sorted(cycles([sigma[e] for e in alpha]), key=len)
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
        place = links[point].index(ring.start)
        links[point][place : place + 1] = [ring[i - 1], ring[i]]
    own = {first_vertex + i for i, vertex in enumerate(vertices) if vertex[0] < drawn.own}
    rooms = [
        [ROOM if own & {i, a, b} else 1.0 for a, b in pairwise([link[-1], *link])]
        for i, link in enumerate(links)
    ]
    return Mesh(links, rooms, first_vertex, ring)


def place(net: Mesh) -> list[complex]:
    """Coordinates of each point, such that no triangle is turned over.

    The plane has y downwards, so clockwise is the sense of growing angles.  The unit is about
    the side of a triangle.

    Cost: O(SWEEPS) times the points, for small maps.
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
    """Move a point to a place where the triangles around it are less strained."""
    here = points[i]
    strain, step = _strain(here, i, net, points)
    step *= FURTHER
    for _ in range(6):
        if _strain(here + step, i, net, points)[0] < strain:
            points[i] = here + step
            return
        step /= 2


def _strain(centre: complex, i: int, net: Mesh, points: Sequence[complex]) -> tuple[float, complex]:
    """The strain of the triangles around a point, and the step that should lower it.

    The strain of a triangle with area A/2, squares of sides of sum S and wanted area R/2 is
    S/A + R/A + A/R: infinite for one that is turned over.
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
