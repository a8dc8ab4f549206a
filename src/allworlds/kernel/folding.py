"""The folded log: whether the walk alone determines the map, whatever the explorer says.

A tree of fresh nodes is walked as the log says; on each arrival at v0 the node is merged with
v0, aligned by the bearing, and merging goes on where one dart would lead to two places.  The
twin is :mod:`allworlds.judge.folding`.
"""

from __future__ import annotations

from allworlds.kernel.compiling import inlined, inner
from allworlds.kernel.records import NONE


@inner
def folds(world, log, fold):
    """Whether no dart of the folded log is open; the log is that of a directional lighthouse."""
    start = world.start
    home, bearing = world.degree[start], world.bearing[start]
    fold.nodes = fold.darts = 0
    _add(fold, home)
    dart = fold.first[0]
    for step in range(log.cost):
        dart = _root(fold, dart)
        v = fold.node[dart]
        leaving = dart + log.motion[step]
        if leaving >= fold.first[v] + fold.degree[v]:
            leaving -= fold.degree[v]
        if fold.link[leaving] == NONE:
            arrived = _add(fold, log.degree[step])
            fold.link[leaving], fold.link[arrived] = arrived, leaving
        dart = fold.link[leaving]
        if log.marks[step]:
            turn = bearing - log.bearing[step]
            if turn < 0:
                turn += home
            if not _merge(fold, dart, turn):
                return False
    for v in range(fold.nodes):
        if fold.parent[v] == v:
            for dart in range(fold.first[v], fold.first[v] + fold.degree[v]):
                if fold.link[dart] == NONE:
                    return False
    return True


@inner
def _add(fold, degree):
    """A fresh node; its first dart."""
    first, v = fold.darts, fold.nodes
    for dart in range(first, first + degree):
        fold.node[dart], fold.link[dart] = v, NONE
    fold.first[v], fold.degree[v] = first, degree
    fold.parent[v], fold.shift[v] = v, 0
    fold.darts += degree
    fold.nodes += 1
    return first


@inner
def _root(fold, dart):
    """The dart of the root node that stands for this one.

    Dart i of a merged node is dart ``i + shift`` (modulo the degree) of its parent.
    """
    v = fold.node[dart]
    while fold.parent[v] != v:
        w = fold.parent[v]
        place = dart - fold.first[v] + fold.shift[v]
        if place >= fold.degree[v]:
            place -= fold.degree[v]
        dart = fold.first[w] + place
        v = w
    return dart


@inlined
def _merge(fold, a, b):
    """Dart a is dart b; so are their vertices, and where their darts lead to.

    False where two percepts of one vertex differ.
    """
    fold.todo[0], fold.todo[1] = a, b
    waiting = 1
    while waiting:
        waiting -= 1
        a, b = _root(fold, fold.todo[2 * waiting]), _root(fold, fold.todo[2 * waiting + 1])
        if a == b:
            continue
        v, w = fold.node[a], fold.node[b]
        degree = fold.degree[v]
        if v == w or degree != fold.degree[w]:
            return False
        if v < w:
            # The older node stays, so that v0 is always a root.
            a, b, v, w = b, a, w, v
        shift = (b - fold.first[w]) - (a - fold.first[v])
        if shift < 0:
            shift += degree
        fold.parent[v], fold.shift[v] = w, shift
        for i in range(degree):
            x = fold.first[v] + i
            if fold.link[x] == NONE:
                continue
            y = _root(fold, x)
            if fold.link[y] == NONE:
                fold.link[y] = fold.link[x]
            else:
                fold.todo[2 * waiting], fold.todo[2 * waiting + 1] = fold.link[x], fold.link[y]
                waiting += 1
    return True
