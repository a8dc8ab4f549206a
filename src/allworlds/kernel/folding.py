"""The folded log: whether the walk alone determines the map, whatever the explorer says.

A tree of fresh nodes is walked as the log says; on each arrival at v0 the node is merged with
v0, aligned by the bearing, and merging goes on where one dart would lead to two places.  The
twin is :mod:`allworlds.judge.folding`.

Dart i of node v is the number ``v << NODE | i``; of each node it is known which of its darts lead
somewhere, as a set, so that no dart is looked at of which nothing is known.
"""

from __future__ import annotations

from allworlds.kernel.bits import lowest
from allworlds.kernel.compiling import inlined, inner
from allworlds.kernel.records import DARTS

NODE = DARTS.bit_length() - 1
PLACE = DARTS - 1


@inner
def folds(world, log, fold):
    """Whether no dart of the folded log is open; the log is that of a directional lighthouse."""
    start = world.start
    home, bearing = world.degree[start], world.bearing[start]
    fold.nodes = 0
    dart = _add(fold, home)
    for step in range(log.cost):
        v, place = dart >> NODE, (dart & PLACE) + log.motion[step]
        if place >= fold.degree[v]:
            place -= fold.degree[v]
        leaving = v << NODE | place
        if not fold.linked[v] >> place & 1:
            _lead(fold, leaving, _add(fold, log.degree[step]))
        dart = fold.link[leaving]
        if log.marks[step]:
            turn = bearing - log.bearing[step]
            if turn < 0:
                turn += home
            if not _merge(fold, dart, turn):
                return False
        dart = _root(fold, dart)
    for v in range(fold.nodes):
        if fold.parent[v] == v and fold.linked[v] != (1 << fold.degree[v]) - 1:
            return False
    return True


@inlined
def _add(fold, degree):
    """A fresh node; its first dart."""
    v = fold.nodes
    fold.nodes = v + 1
    fold.degree[v], fold.parent[v], fold.shift[v], fold.linked[v] = degree, v, 0, 0
    return v << NODE


@inlined
def _lead(fold, dart, other):
    """These two darts, of which nothing was known, lead to each other."""
    fold.link[dart], fold.link[other] = other, dart
    fold.linked[dart >> NODE] |= 1 << (dart & PLACE)
    fold.linked[other >> NODE] |= 1 << (other & PLACE)


@inlined
def _root(fold, dart):
    """The dart of the root node that stands for this one.

    Dart i of a merged node is dart ``i + shift`` (modulo the degree) of its parent.
    """
    v = dart >> NODE
    while fold.parent[v] != v:
        place = (dart & PLACE) + fold.shift[v]
        if place >= fold.degree[v]:
            place -= fold.degree[v]
        v = fold.parent[v]
        dart = v << NODE | place
    return dart


@inlined
def _merge(fold, a, b):
    """Dart a is dart b; so are their vertices, and where their darts lead to.

    False where two percepts of one vertex differ.
    """
    waiting = 0
    while True:
        a, b = _root(fold, a), _root(fold, b)
        if a != b:
            v, w = a >> NODE, b >> NODE
            degree = fold.degree[v]
            if v == w or degree != fold.degree[w]:
                return False
            if v < w:
                # The older node stays, so that v0 is always a root.
                a, b, v, w = b, a, w, v
            shift = (b & PLACE) - (a & PLACE)
            if shift < 0:
                shift += degree
            fold.parent[v], fold.shift[v] = w, shift
            left = fold.linked[v]
            while left:
                place = lowest(left)
                left &= left - 1
                x, y = v << NODE | place, place + shift
                if y >= degree:
                    y -= degree
                if fold.linked[w] >> y & 1:
                    fold.todo[2 * waiting] = fold.link[x]
                    fold.todo[2 * waiting + 1] = fold.link[w << NODE | y]
                    waiting += 1
                else:
                    fold.link[w << NODE | y] = fold.link[x]
                    fold.linked[w] |= 1 << y
        if waiting == 0:
            return True
        waiting -= 1
        a, b = fold.todo[2 * waiting], fold.todo[2 * waiting + 1]
