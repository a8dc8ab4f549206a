"""A second judge of an answer: the paper's definition of 'the same map', read literally.

Section V: a map and a world are the same if they are isomorphic as graphs, by some ``phi``,
and at each vertex v the index of an edge e and the index of ``phi(e)`` at ``phi(v)`` differ by
a relabelling, a cyclic shift that depends on v alone.  So all graph isomorphisms are generated,
by networkx, and each is tested for the edge-index condition.

An isomorphism of graphs with loops and parallel edges says also which edge goes to which, and
which way round.  To express that by an isomorphism of plain graphs, each edge is divided by
two nodes, its darts, coloured so that they are not taken for vertices.

This module shares no code with the search that walks two maps from a pair of darts; it is
compared with that search, on small maps.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    from collections.abc import Iterator

    from allworlds.maps.combinatorial import CombinatorialMap, Dart


def same_map(a: CombinatorialMap, b: CombinatorialMap) -> bool:
    """Whether some graph isomorphism of a to b satisfies the edge-index condition.

    Cost: as many tests of O(m) as there are graph isomorphisms, at worst ``m! 2^m`` for m loops
    at one vertex (384 for m = 4): meant for m <= 4.

    Source: Section V, the extended definition of graph isomorphism.
    """
    return any(_keeps_indices(a, b, phi) for phi in _graph_isomorphisms(a, b))


def same_pose(a: CombinatorialMap, here_a: Dart, b: CombinatorialMap, here_b: Dart) -> bool:
    """Whether some isomorphism that satisfies the edge-index condition takes here_a to here_b.

    Raises:
        ValueError: if one of the darts is none of its map.

    Cost: as :func:`same_map`.
    """
    for dart, owner in ((here_a, a), (here_b, b)):
        if dart not in owner.darts:
            raise ValueError(f"{dart} is no dart; darts are 0..{len(owner.darts) - 1}")
    return any(
        phi[here_a] == here_b and _keeps_indices(a, b, phi) for phi in _graph_isomorphisms(a, b)
    )


def verdict(
    truth_map: CombinatorialMap,
    truth_dart: Dart,
    estimate_map: CombinatorialMap,
    estimate_here: Dart,
) -> Literal["right", "map", "pose"]:
    """The verdict: ``right``, or the wrong part: the ``map``, or in the right map the ``pose``.

    Raises:
        ValueError: if one of the darts is none of its map.

    Cost: as :func:`same_map`.
    """
    if same_pose(truth_map, truth_dart, estimate_map, estimate_here):
        return "right"
    return "pose" if same_map(truth_map, estimate_map) else "map"


def _graph_isomorphisms(a: CombinatorialMap, b: CombinatorialMap) -> Iterator[dict[Dart, Dart]]:
    """Each isomorphism of the two graphs without their rotations, as a map of the darts."""
    from networkx.algorithms.isomorphism import GraphMatcher

    # Graph isomorphisms keep degrees; most pairs need no search.
    if sorted(a.degrees) != sorted(b.degrees):
        return
    matcher = GraphMatcher(_divided(a), _divided(b), node_match=lambda x, y: x == y)
    for phi in matcher.isomorphisms_iter():
        yield {d: phi["dart", d][1] for d in a.darts}


def _divided(a: CombinatorialMap) -> Any:
    """The graph of the map, each edge divided by its two darts; the rotations are forgotten."""
    from networkx import Graph

    graph = Graph()
    for v, darts in enumerate(a.vertices):
        graph.add_node(("vertex", v), kind="vertex")
        for d in darts:
            graph.add_node(("dart", d), kind="dart")
            graph.add_edge(("vertex", v), ("dart", d))
    graph.add_edges_from((("dart", d), ("dart", e)) for d, e in a.edges)
    return graph


def _keeps_indices(a: CombinatorialMap, b: CombinatorialMap, phi: dict[Dart, Dart]) -> bool:
    """The edge-index condition: at each vertex all indices are shifted by the same number."""
    index = {d: i for darts in b.vertices for i, d in enumerate(darts)}
    return all(
        len({(index[phi[d]] - i) % len(darts) for i, d in enumerate(darts)}) == 1
        for darts in a.vertices
    )
