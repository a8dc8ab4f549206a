"""A glued map as a world, and every kind of lighthouse: its places there, and its percepts.

The darts of a vertex are consecutive and clockwise, the start is 0.  Each kind of lighthouse is a
function that puts it at the next of its places (before the first one ``world.place`` is NONE), or
says by NONE that there is none left.  The twin is :mod:`allworlds.world.lighthouses`.
"""

from __future__ import annotations

from functools import cache

from numba import types

from allworlds.engines.kernel.code import number
from allworlds.engines.kernel.compiling import RECORD, callback, inlined, inner
from allworlds.engines.kernel.records import NONE, WORLD

ALL_CHOICES = 3
"""The largest number of edges for which every choice of a compass's darts is a place."""

ANY, SINGLE, UNIQUE = range(3)
"""The neighbours of v0: all, those that one edge leads to, those that their degree tells apart."""


@inner
def settle(world, g):
    """Write the finished map as a world without a lighthouse."""
    world.darts, world.vertices = g.darts, g.vertices
    world.place = world.pointed = NONE
    for v in range(g.vertices):
        first, degree = g.first[v], g.degree[v]
        world.root[v] = first
        for dart in range(first, first + degree):
            world.owner[dart], world.first[dart], world.degree[dart] = v, first, degree
            world.sigma[dart] = dart + 1
            world.alpha[dart] = g.alpha[dart]
        world.sigma[first + degree - 1] = first
    darken(world)


@inner
def darken(world):
    """Remove the lighthouse: only the degree is sensed, and no number told."""
    world.told = NONE
    for dart in range(world.darts):
        world.marks[dart] = 0
        world.bearing[dart] = NONE


@inlined
def arrival(world, dart, motion):
    """The dart of arrival after leaving ``motion`` places clockwise of the dart."""
    degree, leaving = world.degree[dart], dart + motion
    if leaving >= world.first[dart] + degree:
        leaving -= degree
    return world.alpha[leaving]


@inner
def doubled(world):
    """Return 1 if there is a loop, plus 2 if two edges have the same two ends."""
    found = 0
    for v in range(world.vertices):
        joined = 0
        dart = world.root[v]
        for _ in range(world.degree[dart]):
            u = world.owner[world.alpha[dart]]
            if u == v:
                found |= 1
            elif joined >> u & 1:
                found |= 2
            joined |= 1 << u
            dart += 1
    return found


def none(world):  # pragma: no cover  # compiled
    """Go to the next place of no lighthouse: the one place."""
    world.place = 0 if world.place == NONE else NONE


def position(world):  # pragma: no cover  # compiled
    """Put one mark at v0: one place."""
    world.place = 0 if world.place == NONE else NONE
    _mark(world, 0, 1)


def directional(world):  # pragma: no cover  # compiled
    """Put one mark at v0 that points to one of its darts: each of them is a place."""
    world.place += 1
    if world.place == world.degree[0]:
        world.place = NONE
    else:
        _mark(world, 0, 1)
        _point(world, world.place)


def compass(world):  # pragma: no cover  # compiled
    """Choose a reference dart at each vertex: every choice, or beyond a size the first.

    Vertices and their darts count in canonical order; the dart of the last changes first.
    """
    place = world.place + 1
    if place and world.darts > 2 * ALL_CHOICES:
        world.place = NONE
        return
    number(world, 0)
    # The vertices in the order in which they are met, and the number of each one's dart.
    met = 0
    for v in range(world.vertices):
        world.choice[v] = NONE
    for i in range(world.darts):
        v = world.owner[world.order[i]]
        if world.choice[v] == NONE:
            world.choice[v] = 0
            world.met[met] = v
            met += 1
    rest = place
    for i in range(world.vertices - 1, -1, -1):
        v = world.met[i]
        degree = world.degree[world.root[v]]
        world.choice[v] = rest % degree
        rest //= degree
    if rest:
        world.place = NONE
        return
    world.place = place
    for i in range(world.darts):
        dart = world.order[i]
        v = world.owner[dart]
        if world.choice[v] == 0:
            _point(world, dart)
        world.choice[v] -= 1


def cluster(world):  # pragma: no cover  # compiled
    """Put one mark at v0 and two at a neighbour v1: a place for each dart that leads to one."""
    if _to_neighbour(world, ANY):
        _cluster(world)


def cluster_single(world):  # pragma: no cover  # compiled
    """Do :func:`cluster`, but only where exactly one edge joins v0 and v1."""
    if _to_neighbour(world, SINGLE):
        _cluster(world)


def natural(world):  # pragma: no cover  # compiled
    """Choose a neighbour v1 so that its degree and that of v0 are each of one vertex only.

    The explorer is told the degree of v1.
    """
    if _to_neighbour(world, UNIQUE):
        world.told = world.degree[world.alpha[world.pointed]]


@inner
def _to_neighbour(world, which):
    """Go to the next dart of v0 to such a neighbour; return False if there is no such place."""
    world.place += 1
    while True:
        world.pointed += 1
        if world.pointed == world.degree[0]:
            world.place = NONE
            return False
        v1 = world.owner[world.alpha[world.pointed]]
        if v1 == 0 or (which == SINGLE and _joined(world, v1) > 1):
            continue
        if which != UNIQUE or _unique(world, world.pointed):
            return True


@inner
def _joined(world, vertex):
    """The number of edges between v0 and the vertex."""
    edges = 0
    for dart in range(world.degree[0]):
        edges += world.owner[world.alpha[dart]] == vertex
    return edges


@inner
def _unique(world, dart):
    """Whether the degrees at both ends are of one vertex each; only the first dart to it counts."""
    v1 = world.owner[world.alpha[dart]]
    for before in range(dart):
        if world.owner[world.alpha[before]] == v1:
            return False
    near, far = world.degree[dart], world.degree[world.alpha[dart]]
    alike = 0
    for v in range(world.vertices):
        degree = world.degree[world.root[v]]
        alike += (degree == near) + (degree == far)
    return near != far and alike == 2


@inner
def _cluster(world):
    """Put one mark at v0, two at the other end of the dart of the place, none elsewhere."""
    darken(world)
    _mark(world, 0, 1)
    _mark(world, world.owner[world.alpha[world.pointed]], 2)


@inner
def _mark(world, vertex, marks):
    """Put marks at the vertex."""
    first = world.root[vertex]
    for dart in range(first, first + world.degree[first]):
        world.marks[dart] = marks


@inner
def _point(world, dart):
    """Make the dart the reference dart of its vertex."""
    first, degree = world.first[dart], world.degree[dart]
    for other in range(first, first + degree):
        world.bearing[other] = dart - other
        if other > dart:
            world.bearing[other] += degree


@cache
def lighthouse_address(kind: str) -> int:
    """The address of the compiled lighthouse, one of :data:`capabilities.LIGHTHOUSES`."""
    return callback(globals()[kind.replace("-", "_")], types.void(RECORD(WORLD)))
