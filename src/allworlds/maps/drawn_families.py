"""Families of large worlds, drawn from a seed, in which the costs of explorers differ much.

A vertex is a list of names of edges, clockwise, as :func:`allworlds.maps.build.from_cycles` takes
them; a name that occurs twice at a vertex is a loop.  The rotation at each vertex is drawn unless
the family is embedded in the plane or on the torus.  Dart 0, at which a robot starts, is one of the
first vertex.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import TypeAlias

from allworlds.maps.build import from_cycles
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap

Ends: TypeAlias = list[tuple[int, int]]
"""The edges of a graph: the numbers of the two vertices of each."""


def torus(rows: int, columns: int, random: Random) -> CombinatorialMap:
    """The square lattice on the torus, from any of its darts; m = 2RC.

    Raises:
        ValueError: if there is no row or no column.
    """
    if rows < 1 or columns < 1:
        raise ValueError("R and C are at least 1")
    cells = [(r, c) for r in range(rows) for c in range(columns)]
    start = random.randrange(len(cells))
    around = []
    for r, c in cells[start:] + cells[:start]:
        north, west = (r - 1) % rows, (c - 1) % columns
        around.append([("down", north, c), ("right", r, c), ("down", r, c), ("right", r, west)])
    turned = random.randrange(4)
    around[0] = around[0][turned:] + around[0][:turned]
    return from_cycles(around)


def regular(degree: int, vertices: int, random: Random) -> CombinatorialMap:
    """A connected map in which every vertex has that degree; m = DN/2.

    Raises:
        ValueError: if there is none, or the degree is below 3 (drawn ones would not be connected).
    """
    if degree < 3 or vertices < 1 or degree * vertices % 2:
        raise ValueError("D is at least 3, and D times N is even")
    return _connected(lambda: _paired([v for v in range(vertices) for _ in range(degree)], random))


def cubic(vertices: int, random: Random) -> CombinatorialMap:
    """A connected map in which every vertex has degree 3; m = 3N/2.

    Raises:
        ValueError: for an odd number of vertices, or none.
    """
    if vertices < 1 or vertices % 2:
        raise ValueError("N is even, and at least 2")
    return regular(3, vertices, random)


def sparse(vertices: int, edges: int, random: Random) -> CombinatorialMap:
    """A random tree with random edges besides, loops and parallel ones among them.

    Raises:
        ValueError: if there are fewer edges than a tree has.
    """
    if not 0 < vertices <= edges + 1 or edges < 1:
        raise ValueError("N vertices need N - 1 edges at least, and a map has 1")
    ends = [(v, random.randrange(v)) for v in range(1, vertices)]
    more = edges - len(ends)
    ends += [(random.randrange(vertices), random.randrange(vertices)) for _ in range(more)]
    return _drawn(vertices, ends, random)


def bouquet(loops: int, random: Random) -> CombinatorialMap:
    """A first vertex of degree 1 joined to one with loops, matched at random; m = c + 1."""
    names = [loop for loop in range(loops) for _ in range(2)]
    random.shuffle(names)
    return from_cycles([["stem"], ["stem", *names]])


def lollipop(degree: int, length: int, random: Random) -> CombinatorialMap:
    """A path that looks like the knot at its end, and leads to it from a first vertex of degree 1.

    The path has ``length`` inner vertices, filled up with loops, and the knot as many vertices,
    the last of which has degree D + 1.

    Raises:
        ValueError: for an odd degree, or one below 4.
    """
    if degree < 4 or degree % 2 or length < 1:
        raise ValueError("D is even and at least 4, L at least 1")
    path = list(pairwise(range(length + 2)))
    path += [(v, v) for v in range(1, length + 1) for _ in range(degree // 2 - 1)]
    knot = [v for v in range(length + 1, 2 * length + 1) for _ in range(degree)][1:]
    # The darts of the knot are odd in number: its last vertex has one more.
    knot.append(2 * length)

    def draw() -> CombinatorialMap:
        return _drawn(2 * length + 1, path + _matched(knot, random), random)

    return _connected(draw)


def lollipop_edges(degree: int, length: int) -> int:
    """The number of edges of a lollipop."""
    return length + 1 + length * (degree // 2 - 1) + length * degree // 2


def thick(degree: int, length: int, random: Random) -> CombinatorialMap:
    """A path of ``length`` edges, from its end, each vertex filled up with loops to at most D.

    Raises:
        ValueError: for an odd degree, or one below 2.
    """
    if degree < 2 or degree % 2 or length < 1:
        raise ValueError("D is even and at least 2, L at least 1")
    ends = list(pairwise(range(length + 1)))
    for v in range(length + 1):
        on_path = 1 if v in (0, length) else 2
        ends += [(v, v)] * ((degree - on_path) // 2)
    return _drawn(length + 1, ends, random)


def thick_edges(degree: int, length: int) -> int:
    """The number of edges of a thick path."""
    return length + (length - 1) * (degree // 2 - 1) + 2 * ((degree - 1) // 2)


def switched_prism(length: int, random: Random) -> CombinatorialMap:
    """Two rings with rungs, of which two are crossed: cubic, and nearly symmetric; m = 3N.

    Raises:
        ValueError: for fewer than 3 rungs.
    """
    if length < 3:
        raise ValueError("N is at least 3")
    rungs = [(i, length + i) for i in range(length)]
    half = length // 2
    rungs[half], rungs[half - 1] = (half, length + half - 1), (half - 1, length + half)
    ring = [(i, (i + 1) % length) for i in range(length)]
    return _drawn(2 * length, [*ring, *((length + a, length + b) for a, b in ring), *rungs], random)


BASE_VERTICES, BASE_EDGES = 3, 5


def cover(sheets: int, random: Random) -> CombinatorialMap:
    """A connected k-fold cover of a random map with 3 vertices and 5 edges; m = 5k.

    Only the lighthouse tells its sheets apart.

    Raises:
        ValueError: for no sheet.
    """
    if sheets < 1:
        raise ValueError("K is at least 1")

    def draw() -> CombinatorialMap:
        base = sparse(BASE_VERTICES, BASE_EDGES, random)
        names: dict[tuple[int, int], tuple[int, int]] = {}
        for edge, (d, e) in enumerate((d, e) for d, e in enumerate(base.alpha) if d < e):
            sheet = list(range(sheets))
            random.shuffle(sheet)
            for s in range(sheets):
                names[d, s] = names[e, sheet[s]] = edge, s
        return from_cycles(
            [[names[d, s] for d in around] for around in base.vertices for s in range(sheets)]
        )

    return _connected(draw)


def _matched(darts: list[int], random: Random) -> Ends:
    """A random matching of darts that are given by their vertices."""
    shuffled = darts[:]
    random.shuffle(shuffled)
    return list(zip(shuffled[::2], shuffled[1::2], strict=True))


def _paired(darts: list[int], random: Random) -> CombinatorialMap:
    return _drawn(max(darts) + 1, _matched(darts, random), random)


def _drawn(vertices: int, ends: Ends, random: Random) -> CombinatorialMap:
    """The graph with random rotations."""
    around: list[list[int]] = [[] for _ in range(vertices)]
    for edge, pair in enumerate(ends):
        for v in pair:
            around[v].append(edge)
    for names in around:
        random.shuffle(names)
    return from_cycles(around)


def _connected(draw: Callable[[], CombinatorialMap]) -> CombinatorialMap:
    """The first connected one of these maps."""
    while True:
        try:
            return draw()
        except InvalidMap:
            continue
