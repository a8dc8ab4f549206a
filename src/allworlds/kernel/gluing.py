"""Every rooted map of the class ``maps``, finished one after the other, or only counted.

The gluing is the one of the Python enumeration: the oldest open dart is glued to another
open dart, or to the first dart of a new vertex.  ``advance`` goes from one finished map to
the next; ``count`` keeps only the numbers, and the faces as they close.
"""

from __future__ import annotations

from numba import njit
from numpy import empty, int8, int64, zeros

from allworlds.kernel.bits import lowest, size

DEPTH, DARTS, VERTICES = range(3)

_ROOM = 32


@njit(cache=True, nogil=True)
def advance(edges, limit, prefix, viable, alpha, degree, decision, place, state):
    """Whether there is one more map; it stands in ``alpha`` (-1: open), ``degree``, ``state``.

    Before the first call ``alpha`` is -1, and ``decision``, ``place`` and ``state`` are 0.
    They hold the decision at each depth and the dart that it is about: ``-d`` a new vertex
    of degree d, ``z > 0`` glued to dart z, 0 nothing yet.
    """
    darts = 2 * edges
    depth, w_darts, w_vertices = state[DEPTH], state[DARTS], state[VERTICES]
    while True:
        # Take back the decision at this depth.
        y, last = place[depth], decision[depth]
        if last < 0:
            w_darts += last
            w_vertices -= 1
        if depth > 0 and last != 0:
            alpha[y] = -1
            alpha[w_darts if last < 0 else last] = -1
        # Take the next one.
        if depth < len(prefix):
            following = prefix[depth] if last == 0 else 0
        else:
            following = _following(y, last, alpha, w_darts, w_vertices, darts, limit, viable)
        decision[depth] = following
        if following == 0:
            if depth == 0:
                state[DEPTH], state[DARTS], state[VERTICES] = 0, 0, 0
                return False
            depth -= 1
            continue
        if following < 0:
            degree[w_vertices] = -following
            if depth > 0:
                alpha[y], alpha[w_darts] = w_darts, y
            w_darts -= following
            w_vertices += 1
        else:
            alpha[y], alpha[following] = following, y
        y = 0
        while y < w_darts and alpha[y] >= 0:
            y += 1
        if y == w_darts:
            state[DEPTH], state[DARTS], state[VERTICES] = depth, w_darts, w_vertices
            return True
        depth += 1
        decision[depth] = 0
        place[depth] = y


@njit(cache=True, nogil=True)
def _following(y, last, alpha, w_darts, w_vertices, darts, limit, viable):
    """The decision after ``last`` at dart ``y``: gluings ascending, then degrees; 0 behind all."""
    owed = darts - w_darts
    others = 0
    for z in range(w_darts):
        if z != y and alpha[z] < 0:
            others += 1
    if last >= 0 and others and viable[owed, others - 1]:
        for z in range(max(last, y) + 1, w_darts):
            if alpha[z] < 0:
                return z
    for d in range(max(1, 1 - last), owed + 1):
        if (
            w_vertices < limit
            and viable[owed - d, others + d - 1]
            and (w_vertices + 1 < limit or d == owed)
        ):
            return -d
    return 0


@njit(cache=True, nogil=True)
def _join(after, before, depth, y, z):
    """Glue two open darts; the number of faces that close.

    ``after`` and ``before`` link the open darts round each face of the boundary.  Gluing
    exchanges what follows the two darts, and then they are gone.
    """
    next_y, next_z = after[depth, y], after[depth, z]
    after[depth, y], after[depth, z] = next_z, next_y
    before[depth, next_z], before[depth, next_y] = y, z
    closed = 0
    for dart in (y, z):
        p, q = before[depth, dart], after[depth, dart]
        if p == dart:
            closed += 1
        else:
            after[depth, p], before[depth, q] = q, p
    return closed


@njit(cache=True, nogil=True)
def _copy(after, before, depth):
    for dart in range(_ROOM):
        after[depth + 1, dart] = after[depth, dart]
        before[depth + 1, dart] = before[depth, dart]


@njit(cache=True, nogil=True)
def count(edges, limit, prefix, viable, counts):
    """Adds to ``counts[vertices, faces]`` the maps whose gluing begins with ``prefix``."""
    darts = 2 * edges
    # By depth: the boundary, the open darts, those still to be tried as partners of the
    # oldest, the next degree to be tried, and the numbers of darts, vertices and faces.
    after, before = empty((edges + 2, _ROOM), int8), empty((edges + 2, _ROOM), int8)
    opened, untried = zeros(edges + 2, int64), zeros(edges + 2, int64)
    degrees, made = zeros(edges + 2, int64), zeros(edges + 2, int64)
    vertices, faces = zeros(edges + 2, int64), zeros(edges + 2, int64)
    made[0], vertices[0] = -prefix[0], 1
    opened[0] = (1 << made[0]) - 1
    for dart in range(made[0]):
        after[0, dart], before[0, dart] = (dart + 1) % made[0], (dart - 1) % made[0]
    depth = 0
    fresh = True
    while True:
        open_ = opened[depth]
        owed = darts - made[depth]
        others = open_ & (open_ - 1)
        if fresh:
            if depth + 1 < len(prefix):
                z = prefix[depth + 1]
                untried[depth] = 1 << z if z > 0 else 0
                degrees[depth] = -z if z < 0 else darts
            else:
                untried[depth] = others if others and viable[owed, size(others) - 1] else 0
                degrees[depth] = 1
        y = lowest(open_)
        if owed == 0 and others & (others - 1) == 0:
            # The last two darts; alone on their faces, they close one, else two.
            closed = 1 if after[depth, y] == y else 2
            counts[vertices[depth], faces[depth] + closed] += 1
            if depth == 0:
                return
            depth -= 1
            fresh = False
            continue
        down = depth + 1
        if untried[depth]:
            z = lowest(untried[depth])
            untried[depth] &= untried[depth] - 1
            vertices[down], made[down] = vertices[depth], made[depth]
            _copy(after, before, depth)
        else:
            d = degrees[depth]
            if vertices[depth] + 1 == limit:
                d = max(d, owed)
            while d <= owed and not viable[owed - d, size(others) + d - 1]:
                d += 1
            if d > owed or vertices[depth] >= limit:
                if depth == 0:
                    return
                depth -= 1
                fresh = False
                continue
            degrees[depth] = d + 1 if down >= len(prefix) else darts
            z = made[depth]
            vertices[down], made[down] = vertices[depth] + 1, z + d
            _copy(after, before, depth)
            for dart in range(z, z + d):
                after[down, dart], before[down, dart] = dart + 1, dart - 1
            after[down, z + d - 1], before[down, z] = z, z + d - 1
            open_ |= (1 << (z + d)) - (1 << z)
        faces[down] = faces[depth] + _join(after, before, down, y, z)
        opened[down] = open_ & ~(1 << y | 1 << z)
        if opened[down]:
            depth = down
            fresh = True
        else:
            counts[vertices[down], faces[down]] += 1
            fresh = False
