"""All rooted maps of a class, one after the other, and the lighthouses in them.

The order of the maps is that of the Python twin, :mod:`allworlds.maps.enumeration`.  A *gluing*
makes a map by decisions: each decision joins the oldest open dart to another open dart, or to the
first dart of a new vertex.  Partners are tried in ascending order, and then the degrees of a new
vertex.  A decision is taken only if the map can then be finished.  In classes smaller than ``maps``
a rule decides whether the latest decision is legal.

In all functions ``g`` is the state of the gluing, a structured array ``GLUING``.  ``prefix`` holds
the first decisions of the wanted maps as numbers.  The first number is minus the degree of the
root; each later number is the dart to which the oldest open dart is joined, or minus the degree of
a new vertex.  ``viable`` is the table of :func:`gluing_rule`.

The darts of a vertex are consecutive and clockwise, and the start is dart 0.  Each kind of
lighthouse is a function that moves the lighthouse to its next place.  ``world.place`` is NONE
before the first place and after the last place.  The Python code with the same lighthouses is
:mod:`allworlds.world.lighthouses`.  The *canonical order* of the darts is the order in which a
breadth-first search from the start meets them; at each dart it goes first to sigma, then to alpha.
"""

from collections.abc import Sequence
from functools import cache
from typing import Any

from numba import types
from numpy import array, int64, ones, zeros

from allworlds.engines.kernel.arrays import GLUING, NONE, WORLD, new
from allworlds.engines.kernel.code import number
from allworlds.engines.kernel.compiling import (
    RECORD,
    call,
    callback,
    entry,
    inlined,
    inner,
    lowest,
    size,
)


def gluing_rule(edges: int) -> Any:
    """A table that says which unfinished maps are legal.

    The entry ``[missing, open]`` is for a map to which ``missing`` darts are still to be added,
    besides the ``open`` open darts that it has.  The entry is 0 if ``missing`` is above 0 and
    ``open`` is 0, because no further vertex could then be joined to the map.  All other entries are
    1.  In classes other than ``maps`` the function :func:`rule` excludes further maps.
    """
    viable = ones((2 * edges + 1, 4 * edges + 1), int64)
    viable[1:, 0] = 0
    return viable


def by_vertices_and_faces(
    edges: int, limit: int, prefix: Sequence[int]
) -> dict[tuple[int, int], int]:
    """The number of maps whose first decisions are ``prefix``, by (vertices, faces).

    The maps have ``edges`` edges and at most ``limit`` vertices.  If ``prefix`` is empty, all these
    maps are counted.

    Cost: some 150 ns a map; constant memory.
    """
    counts = zeros((edges + 2, edges + 3), int64)
    # Compiled code needs a first decision, which is the degree of the root.
    for begun in [prefix] if prefix else [(-degree,) for degree in range(1, 2 * edges + 1)]:
        gluing = new(GLUING)
        gluing.edges, gluing.limit = edges, limit
        count(gluing, array(begun, int64), gluing_rule(edges), counts)
    table = counts.tolist()
    return {(n, f): times for n, row in enumerate(table) for f, times in enumerate(row) if times}


@entry
def count(g, prefix, viable, counts):
    """Count each map whose first decisions are ``prefix``, in ``counts[vertices, faces]``.

    ``g`` is a new array ``GLUING`` with the request filled in.  ``viable`` is the table of
    :func:`gluing_rule`.
    """
    while advance(g, prefix, viable):
        faces, left = 0, (1 << g.darts) - 1
        while left:
            faces += 1
            dart = lowest(left)
            while left >> dart & 1:
                left ^= 1 << dart
                dart = g.alpha[dart]
                v = g.owner[dart]
                dart += 1
                if dart == g.first[v] + g.degree[v]:
                    dart = g.first[v]
        counts[g.vertices, faces] += 1


@inner
def advance(g, prefix, viable):
    """Go on to the next map whose first decisions are ``prefix``; return whether there is one.

    ``g`` then holds this map.  Before the first call ``g`` is a new array ``GLUING`` in which the
    request has been filled in.  ``viable`` is the table of :func:`gluing_rule`.
    """
    fresh = g.darts == 0
    if fresh:
        _add_vertex(g, -prefix[0])
    else:
        _take_back(g)
    while True:
        if fresh:
            _look(g, prefix)
        if _decide(g, viable):
            if g.open == 0:
                return True
            g.depth += 1
            fresh = True
        elif g.depth == 0:
            return False
        else:
            g.depth -= 1
            _take_back(g)
            fresh = False


@inlined
def _look(g, prefix):
    """Find the oldest open dart, and list in ``g`` the decisions that are to be tried for it.

    If ``prefix`` prescribes the decision, the list holds only this decision.
    """
    depth = g.depth
    y = lowest(g.open)
    g.oldest[depth] = y
    if depth + 1 < len(prefix):
        z = prefix[depth + 1]
        g.untried[depth] = 1 << z if z > 0 else 0
        g.degree_next[depth] = -z if z < 0 else 1
        g.degree_last[depth] = -z if z < 0 else 0
    else:
        g.untried[depth] = g.open ^ 1 << y
        g.degree_next[depth] = 1
        g.degree_last[depth] = 2 * g.edges


@inlined
def _decide(g, viable):
    """Take the next legal decision about an open dart; return False if no such decision is left.

    The dart is ``g.oldest[g.depth]``; ``g.depth`` is the number of edges that were glued before.
    ``viable`` is the table of :func:`gluing_rule`.
    """
    depth = g.depth
    y = g.oldest[depth]
    while True:
        if g.untried[depth]:
            z = lowest(g.untried[depth])
            g.untried[depth] &= g.untried[depth] - 1
            g.added[depth] = 0
        else:
            degree = g.degree_next[depth]
            most = min(g.degree_last[depth], 2 * g.edges - g.darts)
            if degree > most or g.vertices == g.limit:
                return False
            g.degree_next[depth] += 1
            g.added[depth] = degree
            z = g.darts
            _add_vertex(g, degree)
        g.partner[depth] = z
        g.alpha[y], g.alpha[z] = z, y
        g.open ^= 1 << y | 1 << z
        owed = 2 * g.edges - g.darts
        if viable[owed, size(g.open)] and (owed == 0 or g.vertices < g.limit):
            g.possible = 1
            if g.rule:
                call(g.rule, (g,))
            if g.possible:
                return True
        _take_back(g)


@inner
def _add_vertex(g, degree):
    """Add a vertex of this degree, whose darts are all open."""
    first = g.darts
    for dart in range(first, first + degree):
        g.owner[dart] = g.vertices
        g.alpha[dart] = NONE
    g.first[g.vertices] = first
    g.degree[g.vertices] = degree
    g.vertices += 1
    g.darts += degree
    g.open |= (1 << g.darts) - (1 << first)


@inner
def _take_back(g):
    """Undo the latest decision; its data in ``g`` have the index ``g.depth``."""
    depth = g.depth
    y, z = g.oldest[depth], g.partner[depth]
    g.alpha[y] = g.alpha[z] = NONE
    g.open |= 1 << y | 1 << z
    if g.added[depth]:
        g.vertices -= 1
        g.darts -= g.added[depth]
        g.open &= (1 << g.darts) - 1


def rule(g):  # pragma: no cover  # compiled
    """Set ``g.possible`` to 0 if the map so far is not of the class, or cannot be finished.

    ``g.planar`` and ``g.simple`` define the class.  In simple classes ``g.possible`` may stay 1
    although the map cannot be finished: only the condition of :func:`_simple` is checked.
    """
    depth = g.depth
    new = min(2 * g.edges - g.darts, g.limit - g.vertices)
    if g.planar and not (_one_face(g, g.oldest[depth], g.partner[depth]) and _even(g, new)):
        g.possible = 0
    if g.simple and not _simple(g, new):
        g.possible = 0


@cache
def rule_address() -> int:
    """The address of the compiled rule."""
    return callback(rule, types.void(RECORD(GLUING)))


@inner
def _next_open(g, dart, open_):
    """The first dart of the set ``open_`` that follows ``dart`` on the boundary of its face."""
    while True:
        v = g.owner[dart]
        dart += 1
        if dart == g.first[v] + g.degree[v]:
            dart = g.first[v]
        if open_ >> dart & 1:
            return dart
        dart = g.alpha[dart]


@inner
def _one_face(g, y, z):
    """Whether the latest decision, which has joined the darts y and z, keeps the map planar.

    If both darts existed before, they must have been in one face until they were joined.  If the
    decision has added the vertex of z, the result is True, because a new vertex fits into any face.
    """
    if g.added[g.depth]:
        return True
    before = g.open | 1 << y | 1 << z
    dart = _next_open(g, y, before)
    while dart != y and dart != z:
        dart = _next_open(g, dart, before)
    return dart == z


@inner
def _even(g, new):
    """Whether at most ``new`` faces have an odd number of open darts.

    ``new`` is the largest number of vertices that can still be added.  With more such faces no
    planar map can be finished, because one new vertex makes only one of these faces even.
    """
    odd, rest = 0, g.open
    while rest:
        start = dart = lowest(rest)
        length = 0
        while length == 0 or dart != start:
            rest ^= 1 << dart
            length += 1
            dart = _next_open(g, dart, g.open)
        odd += length & 1
    return odd <= new


@inner
def _simple(g, new):
    """Whether no loop and no parallel edge exists, and each vertex has enough possible neighbours.

    Each open dart of a vertex must be joined to another vertex: to one that has an open dart and is
    no neighbour yet, or to a new vertex.  Up to ``new`` vertices can still be added.
    """
    waiting = 0
    for v in range(g.vertices):
        neighbours = own = 0
        for dart in range(g.first[v], g.first[v] + g.degree[v]):
            if g.alpha[dart] < 0:
                own += 1
                continue
            other = 1 << g.owner[g.alpha[dart]]
            if (neighbours | 1 << v) & other:
                return False
            neighbours |= other
        g.neighbours[v] = neighbours
        g.unmatched[v] = own
        waiting |= (own > 0) << v
    for v in range(g.vertices):
        partners = size(waiting & ~(g.neighbours[v] | 1 << v))
        if g.unmatched[v] > partners + new:
            return False
    return True


ALL_CHOICES = 3
"""The largest number of edges for which every choice of a compass's darts is a place."""

ANY, SINGLE, UNIQUE = range(3)
"""Three sets of neighbours of v0: all neighbours; the neighbours that exactly one edge joins to v0;
the neighbours whose degree no other vertex has, if no other vertex has the degree of v0, either."""


@inner
def settle(world, g):
    """Write the finished map of the gluing ``g`` to ``world``, without a lighthouse."""
    world.darts, world.vertices = g.darts, g.vertices
    world.place = world.pointed = NONE
    for v in range(g.vertices):
        first, degree = g.first[v], g.degree[v]
        world.root[v] = first
        for dart in range(first, first + degree):
            world.owner[dart], world.first[dart], world.degree[dart] = v, first, degree
            world.end[dart] = first + degree
            world.sigma[dart] = dart + 1
            world.alpha[dart] = g.alpha[dart]
        world.sigma[first + degree - 1] = first
    darken(world)


@inner
def darken(world):
    """Remove the lighthouse: only degrees are sensed, and the explorer is told no number."""
    world.told = NONE
    for dart in range(world.darts):
        world.marks[dart] = 0
        world.bearing[dart] = NONE


@inlined
def arrival(world, dart, motion):
    """The dart at which a robot arrives if it makes the motion ``motion`` at this dart."""
    degree, leaving = world.degree[dart], dart + motion
    if leaving >= world.first[dart] + degree:
        leaving -= degree
    return world.alpha[leaving]


@inner
def doubled(world):
    """Return 0, plus 1 if the world has a loop, plus 2 if the world has parallel edges."""
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
    """Go on to the only place of this kind, which puts no lighthouse into the world."""
    world.place = 0 if world.place == NONE else NONE


def position(world):  # pragma: no cover  # compiled
    """Go on to the only place of this kind: one mark at v0."""
    world.place = 0 if world.place == NONE else NONE
    _mark(world, 0, 1)


def directional(world):  # pragma: no cover  # compiled
    """Put one mark at v0 that points to the next dart of v0; each dart of v0 is a place."""
    world.place += 1
    if world.place == world.degree[0]:
        world.place = NONE
    else:
        _mark(world, 0, 1)
        _point(world, world.place)


def door(world):  # pragma: no cover  # compiled
    """Put one mark at the next dart of v0, sensed only on arriving by it; each dart is a place."""
    world.place += 1
    darken(world)
    if world.place == world.degree[0]:
        world.place = NONE
    else:
        world.marks[world.place] = 1


def compass(world):  # pragma: no cover  # compiled
    """Choose the next reference darts, one at each vertex; if none are left, set the place to NONE.

    In maps with at most ALL_CHOICES edges every choice is a place.  In larger maps only the first
    choice is a place: at each vertex the first of its darts in the canonical order.  The choices
    are tried in lexicographic order: vertices and their darts are in canonical order, and the dart
    of the last vertex changes fastest.
    """
    place = world.place + 1
    if place and world.darts > 2 * ALL_CHOICES:
        world.place = NONE
        return
    number(world, 0)
    # The vertices in canonical order, and the number of the chosen dart of each.
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
    """Put one mark at v0, and two marks at v1, the vertex to which the next place leads.

    A place is a dart of v0 that leads to another vertex.  If no place is left, ``world.place``
    becomes NONE.
    """
    if _to_neighbour(world, ANY):
        _cluster(world)


def cluster_single(world):  # pragma: no cover  # compiled
    """Put one mark at v0, and two marks at v1, the vertex to which the next place leads.

    A place is a dart of v0 that leads to another vertex, to which no other dart of v0 leads.  If no
    place is left, ``world.place`` becomes NONE.
    """
    if _to_neighbour(world, SINGLE):
        _cluster(world)


def natural(world):  # pragma: no cover  # compiled
    """Choose the next neighbour v1 of v0, and tell the explorer the degree of v1; put no marks.

    Each neighbour v1 is a place if v0 and v1 have different degrees, and no third vertex has one of
    these two degrees.  If no place is left, ``world.place`` becomes NONE.
    """
    if _to_neighbour(world, UNIQUE):
        world.told = world.degree[world.alpha[world.pointed]]


@inner
def _to_neighbour(world, which):
    """Go on to the next dart of v0 that leads to a wanted neighbour; return False if none is left.

    ``which`` says which neighbours of v0 are wanted.  ANY: every neighbour.  SINGLE: a neighbour
    that exactly one edge joins to v0.  UNIQUE: a neighbour for which :func:`_unique` is True.  The
    dart is written to ``world.pointed``.
    """
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
    """The number of edges between v0 and the vertex ``vertex``."""
    edges = 0
    for dart in range(world.degree[0]):
        edges += world.owner[world.alpha[dart]] == vertex
    return edges


@inner
def _unique(world, dart):
    """Whether the degrees of v0 and v1 are different, and no other vertex has one of them.

    Here v1 is the vertex to which this dart of v0 leads.  If an earlier dart of v0 also leads to
    v1, the result is False.
    """
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
    """Put one mark at v0, two marks at the other end of the pointed dart, and none elsewhere."""
    darken(world)
    _mark(world, 0, 1)
    _mark(world, world.owner[world.alpha[world.pointed]], 2)


@inner
def _mark(world, vertex, marks):
    """Let a robot sense this number of marks at the vertex, by whichever dart it arrives."""
    first = world.root[vertex]
    for dart in range(first, first + world.degree[first]):
        world.marks[dart] = marks


@inner
def _point(world, dart):
    """Let the marker at the vertex of ``dart`` point to ``dart``: set the bearings of its darts."""
    first, degree = world.first[dart], world.degree[dart]
    for other in range(first, first + degree):
        world.bearing[other] = dart - other
        if other > dart:
            world.bearing[other] += degree


@cache
def lighthouse_address(kind: str) -> int:
    """The address of the compiled lighthouse; :data:`capabilities.LIGHTHOUSES` lists the kinds."""
    return callback(globals()[kind.replace("-", "_")], types.void(RECORD(WORLD)))
