"""Matchings: one more edge by an alternating path, in graphs that need not be bipartite."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Mapping


def augmented(
    allowed: Mapping[int, Collection[int]], mate: Mapping[int, int], root: int
) -> dict[int, int] | None:
    """A matching with one edge more, by an alternating path from a free vertex.

    Args:
        allowed: the neighbours of every vertex.
        mate: a matching of them, both ways.
        root: a vertex without a mate.

    Returns:
        the mates, both ways; None if no alternating path from the root ends in another free vertex.

    Cost: O(n^3).  Source: J. Edmonds, Paths, trees, and flowers, Canad. J. Math. 17 (1965).
    """
    new = dict(mate)
    base = {v: v for v in allowed}
    parent: dict[int, int] = {}
    outer, queue = {root}, deque([root])
    while queue:
        v = queue.popleft()
        for w in sorted(allowed[v]):
            if base[v] == base[w] or new.get(v) == w:
                continue
            if w in outer:
                stem = _stem(v, w, base, parent, new)
                blossom = _side(v, w, stem, base, parent, new)
                blossom |= _side(w, v, stem, base, parent, new)
                for u in sorted(u for u in allowed if base[u] in blossom):
                    base[u] = stem
                    if u not in outer:
                        outer.add(u)
                        queue.append(u)
            elif w not in parent:
                parent[w] = v
                if w not in new:
                    _flip(w, parent, new)
                    return new
                outer.add(new[w])
                queue.append(new[w])
    return None


def _stem(
    v: int, w: int, base: Mapping[int, int], parent: Mapping[int, int], mate: Mapping[int, int]
) -> int:
    """The base of the blossom that an edge between two outer vertices closes."""
    above = set()
    while True:
        v = base[v]
        above.add(v)
        if v not in mate:
            break
        v = parent[mate[v]]
    while base[w] not in above:
        w = parent[mate[base[w]]]
    return base[w]


def _side(
    v: int,
    child: int,
    stem: int,
    base: Mapping[int, int],
    parent: dict[int, int],
    mate: Mapping[int, int],
) -> set[int]:
    """The bases on one side of a blossom; their parents are turned towards the other side."""
    inside = set()
    while base[v] != stem:
        inside |= {base[v], base[mate[v]]}
        parent[v] = child
        child = mate[v]
        v = parent[child]
    return inside


def _flip(end: int, parent: Mapping[int, int], mate: dict[int, int]) -> None:
    """Exchange the edges in and out of the matching along the path to its other end."""
    vertex: int | None = end
    while vertex is not None:
        before = parent[vertex]
        following = mate.get(before)
        mate[vertex], mate[before] = before, vertex
        vertex = following
