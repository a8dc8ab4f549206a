"""Every rooted map of a class, finished one after the other, in the order of the Python twin.

The oldest open dart is glued to another open dart, partners ascending, or to the first dart of
a new vertex, degrees ascending.  Only maps that can be finished are begun.  For the classes smaller
than ``maps`` a rule looks at a partial map, and says whether its latest decision is legal.

The twin is :mod:`allworlds.maps.enumeration`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

from numba import types
from numpy import array, int64, ones, zeros

from allworlds.engines.kernel.compiling import RECORD, callback, entry, inlined, inner
from allworlds.engines.kernel.instructions import call, lowest, size
from allworlds.engines.kernel.records import GLUING, NONE, new


def gluing_rule(edges: int) -> Any:
    """The rule by darts owed and open: the last open dart may not close while darts are owed."""
    viable = ones((2 * edges + 1, 4 * edges + 1), int64)
    viable[1:, 0] = 0
    return viable


def by_vertices_and_faces(
    edges: int, limit: int, prefix: Sequence[int]
) -> dict[tuple[int, int], int]:
    """The number of maps whose gluing begins with ``prefix``, by (vertices, faces).

    Cost: some 150 ns a map; constant memory.
    """
    counts = zeros((edges + 2, edges + 3), int64)
    # Compiled code begins with a first decision, which is the degree of the root.
    for begun in [prefix] if prefix else [(-degree,) for degree in range(1, 2 * edges + 1)]:
        gluing = new(GLUING)
        gluing.edges, gluing.limit = edges, limit
        count(gluing, array(begun, int64), gluing_rule(edges), counts)
    rows = counts.tolist()
    return {(n, f): times for n, row in enumerate(rows) for f, times in enumerate(row) if times}


@entry
def count(g, prefix, viable, counts):
    """Add to ``counts[vertices, faces]`` the maps whose gluing begins with ``prefix``."""
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
    """Whether there is one more map whose first decisions are ``prefix``; ``g`` holds it.

    Before the first call the record is new, with the request filled in.
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
    """List the decisions that are tried for the oldest open dart."""
    depth = g.depth
    y = lowest(g.open)
    g.place[depth] = y
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
    """Take the next decision at this depth; return whether there was one."""
    depth = g.depth
    y = g.place[depth]
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
    """Add a vertex whose darts are open."""
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
    """Undo the decision at this depth."""
    depth = g.depth
    y, z = g.place[depth], g.partner[depth]
    g.alpha[y] = g.alpha[z] = NONE
    g.open |= 1 << y | 1 << z
    if g.added[depth]:
        g.vertices -= 1
        g.darts -= g.added[depth]
        g.open &= (1 << g.darts) - 1


def rule(g):  # pragma: no cover  # compiled
    """Set ``g.possible``: whether the partial map is of the class, and can be finished.

    In the simple classes the second part is decided by a count of the partners left alone.
    """
    depth = g.depth
    new = min(2 * g.edges - g.darts, g.limit - g.vertices)
    if g.planar and not (_one_face(g, g.place[depth], g.partner[depth]) and _even(g, new)):
        g.possible = 0
    if g.simple and not _simple(g, new):
        g.possible = 0


@cache
def rule_address() -> int:
    """The address of the compiled rule."""
    return callback(rule, types.void(RECORD(GLUING)))


@inner
def _next_open(g, dart, open_):
    """The open dart behind this one on the boundary of its face."""
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
    """Whether y and z, just joined, were open in one face; a new vertex may join any."""
    if g.added[g.depth]:
        return True
    before = g.open | 1 << y | 1 << z
    dart = _next_open(g, y, before)
    while dart != y and dart != z:
        dart = _next_open(g, dart, before)
    return dart == z


@inner
def _even(g, new):
    """Whether there are new vertices enough to even out the faces with an odd boundary."""
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
    """Whether there is no loop, no parallel edge, and each vertex has partners enough left."""
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
