"""The demand-driven check of Algorithm 1: every rooted map, decided only where it is looked at.

Two partial maps grow side by side.  The world W has darts that are decided, each with its
partner, and open ones; ``owed`` more darts have not come into being.  The robot's S and U
are as in the paper, with ``image``: for each dart of S the dart of W that it stands for.
The robot walks until it is about to cross an open dart of W.  Then every way to decide that
dart is tried in turn: gluing it to another open dart, or to the first dart of a new vertex.
None is tried from which W could not be finished.  A walk that ends has met one world, and
each finished map ends exactly one walk.

What is checked in each pass is what makes I-1, I-2 and the variant hold after it: a new
vertex of S has not been in S, and a dart closed to a loop leads in W where it leads in S.
The robot closes a loop only on an arrival at v0 in the dart that the path ends with; that
arrival also merges the log's node with v0, so the folded log holds every edge of S.  At the
end S must be all of W.  Nothing is copied to come back to a decision: entries of open darts
and of vertices that do not exist any more are never read.

Source: Algorithm 1, Sections IV and V.
"""

from __future__ import annotations

from numba import njit
from numpy import empty, int64, zeros
from numpy import uint64 as at

from allworlds.kernel.bits import highest, lowest, size
from allworlds.kernel.code import encode, keep_least, rotation
from allworlds.kernel.names import (
    AT_V0,
    BROKEN,
    CASE_1,
    CASE_2,
    EMPTY_H,
    FAILED,
    FIFO,
    LARGEST,
    LIFO,
    LOOP_EDGE,
    PARALLEL_EDGE,
    TRAVERSALS,
    WORLDS,
)

# ``at`` tells the compiler that an index is not negative, so that it does not provide for
# indices that count from the end: that saves a fifth of the time.

# One number holds the cost and the counters of a walk, so that a decision saves one number.
_COST = 0xFFFFF
_CASE_1 = 1 << 20
_CASE_2 = 1 << 28
_AT_V0 = 1 << 36
_EMPTY_H = 1 << 44
_LOOP = 1 << 52
_PARALLEL = 1 << 53
_FEW = 0xFF

# Where the walk stands when it needs the partner of the dart y.
_EDGE, _PATH, _PICK, _NEXT, _FINISH, _BACK = range(6)

_ROOM = 80
"""More than the darts of a world, so that also a robot that errs stays within its buffers."""

_SAVED = 22


@njit(cache=True, nogil=True)
def _distance(adjacent, start, goal):
    """The length of a shortest walk in S; the vertices are joined."""
    reached = 1 << start
    front = reached
    steps = 0
    while not reached >> goal & 1:
        steps += 1
        after = 0
        while front:
            after |= adjacent[lowest(front)]
            front &= front - 1
        front = after & ~reached
        if not front:
            return steps
        reached |= front
    return steps


@njit(cache=True, nogil=True)
def _ways_home(vertices, adjacent, own, explored, owner, partner):
    """For each vertex of S its distance to v0, and the first dart that leads nearer, packed."""
    level = parent = 0
    reached = front = 1
    steps = 0
    while front:
        steps += 1
        after = 0
        while front:
            after |= adjacent[lowest(front)]
            front &= front - 1
        front = after & ~reached
        reached |= front
        rest = front
        while rest:
            level |= steps << (4 * lowest(rest))
            rest &= rest - 1
    for v in range(1, vertices):
        nearer = (level >> (4 * v) & 15) - 1
        ways = own[v] & explored
        while level >> (4 * owner[partner[lowest(ways)]]) & 15 != nearer:
            ways &= ways - 1
        parent |= lowest(ways) << (5 * (v - 1))
    return level, parent


@njit(cache=True, nogil=True)
def _nearest(unexplored, adjacent, own, position):
    """The first among the darts in U with the shortest walk."""
    reached = front = 1 << position
    while front:
        after = darts = 0
        while front:
            v = lowest(front)
            front &= front - 1
            darts |= own[v]
            after |= adjacent[v]
        if darts & unexplored:
            return lowest(darts & unexplored)
        front = after & ~reached
        reached |= front
    return lowest(unexplored)


@njit(cache=True, nogil=True)
def explore(
    edges,
    limit,
    policy,
    prefix,
    tables,
    halt,
    counts,
    least,
    listed,
):
    """Every world whose gluing begins with ``prefix``, walked once, tallied.

    Args:
        edges: m, at most MOST_EDGES.
        limit: the largest number of vertices, at most m + 1.
        policy: FIFO, LIFO or NEAREST.
        prefix: decisions about the oldest open dart, as in the Python enumeration; at least
            the root's degree.
        tables: see :func:`allworlds.kernel.tables.tables`.
        halt: ``halt[0]`` is not 0 once the work is to be given up.
        counts: by vertices; added to.
        least: the least worlds that break a law: vertices, then the canonical code.
        listed: each world while there is room: cost, vertices, degrees, then partners.

    Returns:
        The number of worlds.
    """
    bound, viable, sensed, fuel, back_weight = tables
    darts = 2 * edges
    # The world W.
    partner, owner = zeros(_ROOM, int64), zeros(_ROOM, int64)
    first, degree = zeros(_ROOM, int64), zeros(_ROOM, int64)
    # The robot's S: alpha, vertex and image of a dart; first dart, degree, darts of a vertex.
    s_partner, s_owner, image = zeros(_ROOM, int64), zeros(_ROOM, int64), zeros(_ROOM, int64)
    s_first, s_degree, own = zeros(_ROOM, int64), zeros(_ROOM, int64), zeros(_ROOM, int64)
    of_degree = zeros(_ROOM, int64)
    adjacent = zeros(_ROOM, int64)
    # What each pass has added, so that it can be taken back.
    one_end, other_end = zeros(_ROOM, int64), zeros(_ROOM, int64)
    saved = empty((darts + 1, _SAVED), int64)
    worlds = 0

    # The decisions of the prefix.
    w_darts = -prefix[0]
    w_vertices = 1
    degree[0] = w_darts
    open_ = (1 << w_darts) - 1
    for i in range(1, len(prefix)):
        y = lowest(open_)
        z = prefix[i]
        if z < 0:
            z = w_darts
            first[at(w_vertices)], degree[at(w_vertices)] = z, -prefix[i]
            for dart in range(z, z - prefix[i]):
                owner[at(dart)] = w_vertices
            w_vertices += 1
            w_darts -= prefix[i]
            open_ |= (1 << w_darts) - (1 << z)
        partner[at(y)], partner[at(z)] = z, y
        open_ &= ~(1 << y | 1 << z)

    # S is v0; the dart that the robot faces is dart 0 of both.
    d0 = degree[0]
    for dart in range(d0):
        image[at(dart)] = dart
    s_degree[0] = d0
    own[0] = unexplored = (1 << d0) - 1
    s_darts, s_vertices, in_s = d0, 1, 1
    passes = level = parent = total = 0
    position = e = candidate = h = steps = x = t = y = z = 0
    depth = 0
    stage = _PICK
    while True:
        if stage == _PICK:
            if total & _COST > fuel:
                stage = _FINISH
            elif unexplored:
                if policy == FIFO:
                    e = lowest(unexplored)
                elif policy == LIFO:
                    e = highest(unexplored)
                else:
                    e = _nearest(unexplored, adjacent, own, position)
                unexplored ^= 1 << e
                v = s_owner[at(e)]
                if position == v:
                    total += 1
                elif position == 0:
                    total += 1 + (level >> (4 * v) & 15)
                elif v == 0:
                    total += 1 + (level >> (4 * position) & 15)
                else:
                    total += 1 + _distance(adjacent, position, v)
                y = image[at(e)]
                stage = _EDGE
            else:
                whole = open_ == 0 and s_darts == darts and w_darts == darts
                if whole and s_vertices == w_vertices:
                    worlds += 1
                    n, cost = w_vertices, total & _COST
                    counts[at(n), WORLDS] += 1
                    counts[at(n), TRAVERSALS] += cost
                    counts[at(n), LARGEST] = max(counts[at(n), LARGEST], cost)
                    counts[at(n), CASE_1] += total >> 20 & _FEW
                    counts[at(n), CASE_2] += total >> 28 & _FEW
                    counts[at(n), AT_V0] += total >> 36 & _FEW
                    counts[at(n), EMPTY_H] += total >> 44 & _FEW
                    counts[at(n), LOOP_EDGE] += total >> 52 & 1
                    counts[at(n), PARALLEL_EDGE] += total >> 53 & 1
                    if cost > bound[n]:
                        _blame(counts, least, n, degree, darts, partner)
                    if worlds <= listed.shape[0]:
                        _list(listed[worlds - 1], cost, n, degree, darts, partner)
                    stage = _BACK
                else:
                    stage = _FINISH
        if stage == _NEXT:
            if total & _COST > fuel:
                stage = _FINISH
            elif h:
                candidate = lowest(h)
                h &= h - 1
                v = s_owner[at(candidate)]
                p = parent >> (5 * (v - 1)) & 31
                t = s_partner[at(p)]
                turn = p - candidate
                if turn < 0:
                    turn += s_degree[at(v)]
                w = owner[at(x)]
                y = x + turn
                if y >= first[at(w)] + degree[at(w)]:
                    y -= degree[at(w)]
                steps = 0
                stage = _PATH
            else:
                # Lines 20-21: a new vertex of S.
                w = owner[at(x)]
                d = sensed[at(degree[at(w)])]
                if in_s >> w & 1 or s_darts + d > darts:
                    stage = _FINISH
                    continue
                in_s |= 1 << w
                v = s_vertices
                s_first[at(v)], s_degree[at(v)] = s_darts, d
                own[at(v)] = (1 << (s_darts + d)) - (1 << s_darts)
                of_degree[at(d)] |= own[at(v)]
                turned = x
                for dart in range(s_darts, s_darts + d):
                    s_owner[at(dart)] = v
                    image[at(dart)] = turned
                    turned += 1
                    if turned == first[at(w)] + degree[at(w)]:
                        turned = first[at(w)]
                a = s_owner[at(e)]
                s_partner[at(e)], s_partner[at(s_darts)] = s_darts, e
                unexplored |= own[at(v)] & (own[at(v)] - 1)
                level &= ~(15 << (4 * v))
                parent &= ~(31 << (5 * (v - 1)))
                level |= ((level >> (4 * a) & 15) + 1) << (4 * v)
                parent |= s_darts << (5 * (v - 1))
                adjacent[at(a)] |= 1 << v
                adjacent[at(v)] = 1 << a
                one_end[at(passes)], other_end[at(passes)] = a, v
                passes += 1
                s_vertices += 1
                s_darts += d
                position = v
                stage = _PICK
                continue
        if stage <= _PATH:
            if not open_ >> y & 1:
                z = partner[at(y)]
                if stage == _EDGE:
                    x = z
                    if owner[at(z)]:
                        h = unexplored & of_degree[at(sensed[at(degree[at(owner[at(z)])])])]
                        if not h:
                            total += _EMPTY_H
                        stage = _NEXT
                        continue
                    # The direction tells which dart of v0 this is: a test without a step.
                    total += _AT_V0
                    candidate = z
                else:
                    steps += 1
                    total += 1
                    v = s_owner[at(t)]
                    w = owner[at(z)]
                    if v:
                        if w == 0 or sensed[at(degree[at(w)])] != s_degree[at(v)]:
                            total += back_weight * steps + _CASE_1
                            stage = _NEXT
                            continue
                        p = parent >> (5 * (v - 1)) & 31
                        turn = p - t
                        if turn < 0:
                            turn += s_degree[at(v)]
                        y = z + turn
                        if y >= first[at(w)] + degree[at(w)]:
                            y -= degree[at(w)]
                        t = s_partner[at(p)]
                        continue
                    if z != t:
                        total += back_weight * steps + _CASE_2
                        stage = _NEXT
                        continue
                # Lines 18-19: the dart e closes to a loop with the candidate.
                if (
                    not unexplored >> candidate & 1
                    or partner[at(image[at(e)])] != image[at(candidate)]
                ):
                    stage = _FINISH
                    continue
                unexplored ^= 1 << candidate
                s_partner[at(e)], s_partner[at(candidate)] = candidate, e
                a, b = s_owner[at(e)], s_owner[at(candidate)]
                one_end[at(passes)] = other_end[at(passes)] = 0
                if a == b:
                    total |= _LOOP
                elif adjacent[at(a)] >> b & 1:
                    total |= _PARALLEL
                else:
                    one_end[at(passes)], other_end[at(passes)] = a, b
                    adjacent[at(a)] |= 1 << b
                    adjacent[at(b)] |= 1 << a
                passes += 1
                difference = (level >> (4 * a) & 15) - (level >> (4 * b) & 15)
                far, dart = a, e
                if difference < 0:
                    far, dart, difference = b, candidate, -difference
                if difference == 1:
                    if dart < parent >> (5 * (far - 1)) & 31:
                        parent &= ~(31 << (5 * (far - 1)))
                        parent |= dart << (5 * (far - 1))
                elif difference > 1:
                    explored = ((1 << s_darts) - 1) & ~unexplored
                    level, parent = _ways_home(
                        s_vertices, adjacent, own, explored, s_owner, s_partner
                    )
                position = 0
                stage = _PICK
                continue
            if stage == _PATH and s_owner[at(t)] == 0:
                # The last step would have to end in t, which has its partner: it cannot
                # match, wherever y leads.
                total += 1 + back_weight * (steps + 1) + _CASE_2
                stage = _NEXT
                continue
        elif stage == _FINISH:
            if open_ == 0:
                worlds += 1
                counts[w_vertices, WORLDS] += 1
                counts[w_vertices, FAILED] += 1
                _blame(counts, least, w_vertices, degree, darts, partner)
                stage = _BACK
            else:
                y = lowest(open_)
        if stage != _BACK:
            # The dart y must be decided.
            others = open_ ^ 1 << y
            if w_darts == darts and others & (others - 1) == 0:
                z = lowest(others)
                partner[at(y)], partner[at(z)] = z, y
                open_ = 0
                continue
            if not viable[darts - w_darts, size(others) - 1 if others else 0] or not others:
                others = 0
            saved[at(depth), 0], saved[at(depth), 1] = others, 1
            saved[at(depth), 2], saved[at(depth), 3], saved[at(depth), 4], saved[at(depth), 5] = (
                stage,
                open_,
                unexplored,
                total,
            )
            saved[at(depth), 6], saved[at(depth), 7], saved[at(depth), 8], saved[at(depth), 9] = (
                level,
                parent,
                position,
                passes,
            )
            (
                saved[at(depth), 10],
                saved[at(depth), 11],
                saved[at(depth), 12],
                saved[at(depth), 13],
            ) = (
                w_darts,
                w_vertices,
                s_darts,
                s_vertices,
            )
            (
                saved[at(depth), 14],
                saved[at(depth), 15],
                saved[at(depth), 16],
                saved[at(depth), 17],
            ) = (
                in_s,
                e,
                candidate,
                h,
            )
            (
                saved[at(depth), 18],
                saved[at(depth), 19],
                saved[at(depth), 20],
                saved[at(depth), 21],
            ) = steps, x, t, y
            depth += 1
        # The next way to decide a dart, at the last place where there is one.
        while True:
            if depth == 0 or halt[0]:
                return worlds
            top = at(depth - 1)
            open_, w_darts, w_vertices, y = (
                saved[top, 3],
                saved[top, 10],
                saved[top, 11],
                saved[top, 21],
            )
            if saved[top, 0]:
                z = lowest(saved[top, 0])
                saved[top, 0] &= saved[top, 0] - 1
                break
            owed, others = darts - w_darts, size(open_) - 1
            d = saved[top, 1]
            full = w_vertices + 1 == limit
            if full:
                d = max(d, owed)
            while d <= owed and not viable[at(owed - d), at(others + d - 1)]:
                d += 1
            if d <= owed and w_vertices < limit:
                saved[top, 1] = d + 1
                z = w_darts
                first[at(w_vertices)], degree[at(w_vertices)] = z, d
                for dart in range(z, z + d):
                    owner[at(dart)] = w_vertices
                w_vertices += 1
                w_darts += d
                open_ |= (1 << w_darts) - (1 << z)
                break
            depth -= 1
        partner[at(y)], partner[at(z)] = z, y
        open_ &= ~(1 << y | 1 << z)
        stage, unexplored, total = saved[top, 2], saved[top, 4], saved[top, 5]
        level, parent, position = saved[top, 6], saved[top, 7], saved[top, 8]
        while passes > saved[top, 9]:
            passes -= 1
            a, b = one_end[at(passes)], other_end[at(passes)]
            if a != b:
                adjacent[at(a)] ^= 1 << b
                adjacent[at(b)] ^= 1 << a
        while s_vertices > saved[top, 13]:
            s_vertices -= 1
            of_degree[at(s_degree[at(s_vertices)])] &= ~own[at(s_vertices)]
        s_darts, in_s, e, candidate, h = (
            saved[top, 12],
            saved[top, 14],
            saved[top, 15],
            saved[top, 16],
            saved[top, 17],
        )
        steps, x, t = saved[top, 18], saved[top, 19], saved[top, 20]


@njit(cache=True, nogil=True)
def _blame(counts, least, vertices, degree, darts, partner):
    counts[vertices, BROKEN] += 1
    sigma, row = zeros(_ROOM, int64), zeros(1 + 2 * darts, int64)
    rotation(vertices, degree, sigma)
    row[0] = vertices
    encode(darts, sigma, partner, 0, row[1:])
    keep_least(least, row)


@njit(cache=True, nogil=True)
def _list(row, cost, vertices, degree, darts, partner):
    row[0], row[1] = cost, vertices
    for v in range(vertices):
        row[2 + v] = degree[v]
    for dart in range(darts):
        row[2 + vertices + dart] = partner[dart]
