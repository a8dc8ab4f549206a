"""Ways through the S of a walk, by sets of vertices: lengths, and nearest darts."""

from __future__ import annotations

from allworlds.engines.kernel.bits import lowest
from allworlds.engines.kernel.compiling import inner


@inner
def distance(w, start, goal):
    """The length of a shortest walk in S; the vertices are joined."""
    reached = front = 1 << start
    steps = 0
    while not reached >> goal & 1:
        steps += 1
        after = 0
        while front:
            after |= w.adjacent[lowest(front)]
            front &= front - 1
        front = after & ~reached
        if not front:
            return steps
        reached |= front
    return steps


@inner
def ways_home(w, s):
    """For each vertex of S its distance to v0, and the first dart that leads nearer, packed."""
    level = parent = 0
    reached = front = 1
    steps = 0
    while front:
        steps += 1
        after = 0
        while front:
            after |= w.adjacent[lowest(front)]
            front &= front - 1
        front = after & ~reached
        reached |= front
        rest = front
        while rest:
            level |= steps << (4 * lowest(rest))
            rest &= rest - 1
    explored = ((1 << s.s_darts) - 1) & ~s.unexplored
    for v in range(1, s.s_vertices):
        nearer = (level >> (4 * v) & 15) - 1
        ways = w.own[v] & explored
        while level >> (4 * w.s_owner[w.s_partner[lowest(ways)]]) & 15 != nearer:
            ways &= ways - 1
        parent |= lowest(ways) << (5 * (v - 1))
    s.level, s.parent = level, parent


@inner
def nearest(w, s):
    """The first among the darts in U with the shortest walk."""
    reached = front = 1 << s.position
    while front:
        after = darts = 0
        while front:
            v = lowest(front)
            front &= front - 1
            darts |= w.own[v]
            after |= w.adjacent[v]
        if darts & s.unexplored:
            return lowest(darts & s.unexplored)
        front = after & ~reached
        reached |= front
    return lowest(s.unexplored)
