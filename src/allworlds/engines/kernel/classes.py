"""The rules of the classes smaller than ``maps``: which gluings leave the class.

A rule looks at a partial map whose latest decision has joined ``place`` and ``partner`` at its
depth, and says whether that is legal.  A rule has no memory: it reads all from the partial map.
"""

from __future__ import annotations

from functools import cache

from numba import types

from allworlds.engines.kernel.bits import lowest, size
from allworlds.engines.kernel.compiling import RECORD, callback, inner
from allworlds.engines.kernel.records import GLUING


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
    v = g.owner[dart]
    dart += 1
    while True:
        if dart == g.first[v] + g.degree[v]:
            dart = g.first[v]
        if open_ >> dart & 1:
            return dart
        dart = g.alpha[dart]
        v = g.owner[dart]
        dart += 1


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
