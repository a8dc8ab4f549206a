"""The folded log: whether the walk alone determines the map, for any answer of the explorer.

A tree of fresh nodes is walked as the log says; on each arrival at v0 the node is merged with
v0, aligned by the bearing, and merging goes on where one dart would lead to two places.  The
twin is :mod:`allworlds.judging.laws.folding`.

Merged nodes are one vertex of the true map, since the log is a walk in it: so each node is known
to be a copy of a vertex there, and its darts have that vertex's names.  Which copies are merged
does not depend on the names.  Dart d of node v is the number ``v << NODE | d``; of each node it is
known which of its darts have a known other end, as a set.
"""

from __future__ import annotations

from allworlds.engines.kernel.bits import lowest, size
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.records import DARTS

NODE = DARTS.bit_length() - 1


@inner
def folds(world, log, fold):
    """Whether no dart of the folded log is open; the log is that of a directional lighthouse."""
    _begin(world, fold)
    for step in range(log.cost):
        _step(world, fold, log.arrived[step])
        if fold.open == 0:
            return True
    return False


@inlined
def _begin(world, fold):
    """Begin with the node of v0 alone."""
    fold.parent[0] = fold.linked[0] = fold.node = 0
    fold.open = world.degree[0]
    fold.nodes = 1


@inlined
def _step(world, fold, entered):
    """Fold one step more: the robot arrives by the dart, along an edge that has been decided.

    There must be an open dart; else all is known, and a log is not folded any further.
    """
    leaving, at = world.alpha[entered], fold.node
    if fold.linked[at] >> leaving & 1:
        to = _root(fold, fold.link[at << NODE | leaving])
        if to and world.marks[entered]:
            _merge(world, fold, to, 0)
            to = 0
    elif not world.marks[entered]:
        to = fold.nodes
        fold.nodes += 1
        fold.parent[to], fold.linked[to] = to, 0
        fold.open += world.degree[entered]
        _lead(fold, at, leaving, to, entered)
    else:
        to = 0
        if fold.linked[0] >> entered & 1:
            fold.link[at << NODE | leaving] = 0
            fold.linked[at] |= 1 << leaving
            fold.open -= 1
            _merge(world, fold, at, fold.link[entered])
        else:
            _lead(fold, at, leaving, 0, entered)
    fold.node = to


@inlined
def _lead(fold, v, leaving, w, entered):
    """Join two darts whose other ends were unknown."""
    fold.link[v << NODE | leaving], fold.link[w << NODE | entered] = w, v
    fold.linked[v] |= 1 << leaving
    fold.linked[w] |= 1 << entered
    fold.open -= 2


@inlined
def _root(fold, v):
    """The node that this one has become a part of."""
    while fold.parent[v] != v:
        v = fold.parent[v]
    return v


@inner
def _merge(world, fold, v, w):
    """Merge two nodes, and the nodes behind equal darts."""
    waiting = 0
    while True:
        v, w = _root(fold, v), _root(fold, w)
        if v < w:
            # The older node stays, so that v0 is always a root.
            v, w = w, v
        if v != w:
            fold.parent[v] = w
            both = fold.linked[v] & fold.linked[w]
            more = fold.linked[v] & ~both
            fold.open -= world.degree[lowest(fold.linked[v])] - size(both)
            fold.linked[w] |= more
            while more:
                dart = lowest(more)
                more &= more - 1
                fold.link[w << NODE | dart] = fold.link[v << NODE | dart]
            while both:
                dart = lowest(both)
                both &= both - 1
                fold.todo[2 * waiting] = fold.link[v << NODE | dart]
                fold.todo[2 * waiting + 1] = fold.link[w << NODE | dart]
                waiting += 1
        if waiting == 0:
            return
        waiting -= 1
        v, w = fold.todo[2 * waiting], fold.todo[2 * waiting + 1]
