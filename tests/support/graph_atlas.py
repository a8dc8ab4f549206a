"""A second source for simple maps: rotation systems of every graph of the graph atlas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from itertools import pairwise, permutations, product
from math import factorial, prod
from typing import TypeAlias

from allworlds.maps.counting import catalan, exactly, vertex_counts

ATLAS_VERTICES = 7
"""The graph atlas holds all graphs with at most this many vertices."""

ROTATIONS_LIMIT = 50_000
"""A cell of simple planar maps is left out where its graphs have more rotation systems."""

Graph: TypeAlias = tuple[frozenset[int], ...]
"""Entry v is the set of neighbours of v."""


def rooted_simple(edges: int) -> dict[int, int]:
    """``{vertices: rooted simple maps}``: up to 7 vertices, and trees.

    Sum over connected graphs of ``2m prod (deg-1)! / |Aut|``; the trees beyond are counted by
    Catalan numbers.  Cost: reads the whole atlas once.
    Source: R. C. Read and R. J. Wilson, An Atlas of Graphs (1998).
    """
    counts = {
        n: _rooted(((_rotation_count(graph), graph) for graph in _atlas(n, edges)), edges)
        for n in _atlas_vertices(edges)
    }
    return _with_trees(counts, edges)


def rooted_planar_simple(edges: int) -> dict[int, int]:
    """``{vertices: rooted simple planar maps}``: small cells up to 7 vertices, and trees.

    As :func:`rooted_simple`, with those rotation systems only that have genus 0, found by
    trying all.  A cell whose graphs have more than ROTATIONS_LIMIT of them is left out, unless
    Euler's formula leaves none (``m > 3n - 6`` for n >= 3).
    Cost: at most ROTATIONS_LIMIT face tracings a cell.
    """
    counts = {}
    for n in _atlas_vertices(edges):
        graphs = _atlas(n, edges)
        if n >= 3 and edges > 3 * n - 6:
            counts[n] = 0
        elif sum(map(_rotation_count, graphs)) <= ROTATIONS_LIMIT:
            counts[n] = _rooted(((_spherical_rotations(graph), graph) for graph in graphs), edges)
    return _with_trees(counts, edges)


def _atlas_vertices(edges: int) -> range:
    return range(1, min(ATLAS_VERTICES, max(vertex_counts(edges))) + 1)


def _with_trees(counts: dict[int, int], edges: int) -> dict[int, int]:
    return counts | {edges + 1: counts.get(edges + 1, catalan(edges))}


def _rooted(weighed: Iterable[tuple[int, Graph]], edges: int) -> int:
    """The number of rooted maps on graphs, each given with its number of rotation systems."""
    scale = factorial(ATLAS_VERTICES)  # a multiple of each |Aut|
    total = sum(weight * (scale // _automorphisms(graph)) for weight, graph in weighed)
    return exactly(2 * edges * total, scale)


@cache
def _connected_graphs() -> Mapping[tuple[int, int], list[Graph]]:
    from networkx import graph_atlas_g, is_connected  # slow, and rarely needed

    found: dict[tuple[int, int], list[Graph]] = {}
    for g in graph_atlas_g():
        n, m = g.number_of_nodes(), g.number_of_edges()
        if n and is_connected(g):
            graph = tuple(frozenset(g[v]) for v in range(n))
            found.setdefault((n, m), []).append(graph)
    return found


def _atlas(vertices: int, edges: int) -> list[Graph]:
    return _connected_graphs().get((vertices, edges), [])


def _automorphisms(graph: Graph) -> int:
    """The number of automorphisms of a graph.  Cost: one visit for each, 7! at most."""
    images: list[int] = []

    def extensions() -> int:
        v = len(images)
        if v == len(graph):
            return 1
        total = 0
        for w in range(len(graph)):
            if w in images or len(graph[w]) != len(graph[v]):
                continue
            if all((images[u] in graph[w]) == (u in graph[v]) for u in range(v)):
                images.append(w)
                total += extensions()
                images.pop()
        return total

    return extensions()


def _rotation_count(graph: Graph) -> int:
    return prod(factorial(len(neighbours) - 1) for neighbours in graph)


def _spherical_rotations(graph: Graph) -> int:
    """The number of rotation systems of a connected graph that satisfy ``n - m + f = 2``."""
    faces = 2 - len(graph) + sum(map(len, graph)) // 2
    return sum(_face_count(turn) == faces for turn in _rotation_systems(graph))


def _rotation_systems(graph: Graph) -> Iterator[dict[tuple[int, int], tuple[int, int]]]:
    """Each rotation system as the map from dart (u, v) to the next dart (u, w) round u."""
    choices = []
    for u, neighbours in enumerate(graph):
        first, *others = sorted(neighbours)
        rings = [(first, *order, first) for order in permutations(others)]
        choices.append([[((u, v), (u, w)) for v, w in pairwise(ring)] for ring in rings])
    for chosen in product(*choices):
        yield {dart: following for ring in chosen for dart, following in ring}


def _face_count(turn: Mapping[tuple[int, int], tuple[int, int]]) -> int:
    count = 0
    untraced = set(turn)
    while untraced:
        count += 1
        u, v = start = untraced.pop()
        u, v = turn[v, u]
        while (u, v) != start:
            untraced.remove((u, v))
            u, v = turn[v, u]
    return count
