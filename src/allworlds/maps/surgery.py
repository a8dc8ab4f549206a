"""Maps with an edge less, and the postman's walk."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from allworlds.maps.combinatorial import CombinatorialMap, Dart, InvalidMap, distances


def deleted(map_: CombinatorialMap, dart: Dart) -> CombinatorialMap | None:
    """The map without the edge of ``dart``; None if the rest is disconnected or empty.

    The end of a leaf goes with its edge.
    """
    gone = (dart, map_.alpha[dart])
    return _rebuilt(map_, [[d for d in vertex if d not in gone] for vertex in map_.vertices])


def contracted(map_: CombinatorialMap, dart: Dart) -> CombinatorialMap | None:
    """The map in which both ends of the edge of ``dart`` are one vertex; None for a loop.

    The rotation of one end takes the place that the edge had in the rotation of the other.
    """
    ends = [map_.vertex_of[d] for d in (dart, map_.alpha[dart])]
    if ends[0] == ends[1]:
        return None
    merged = [
        map_.turn(d, k) for d in (dart, map_.alpha[dart]) for k in range(1, map_.degree_at[d])
    ]
    others = [vertex for v, vertex in enumerate(map_.vertices) if v not in ends]
    return _rebuilt(map_, [merged, *others])


def moved(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    """The maps with as many edges in which one dart stands at another place of a rotation."""
    for dart in map_.darts:
        without = [[d for d in vertex if d != dart] for vertex in map_.vertices]
        for v, vertex in enumerate(without):
            for place in range(len(vertex)):
                rotations = [*without[:v], [*vertex[:place], dart, *vertex[place:]]]
                other = _rebuilt(map_, [*rotations, *without[v + 1 :]])
                if other is not None:
                    yield other


def _rebuilt(
    map_: CombinatorialMap, rotations: Sequence[Sequence[Dart]]
) -> CombinatorialMap | None:
    """The map with these rotations on the edges that are left."""
    number = {d: i for i, d in enumerate(sorted(d for vertex in rotations for d in vertex))}
    sigma, alpha = [0] * len(number), [0] * len(number)
    for vertex in rotations:
        for d, following in zip(vertex, [*vertex[1:], *vertex[:1]], strict=True):
            sigma[number[d]] = number[following]
            alpha[number[d]] = number[map_.alpha[d]]
    try:
        return CombinatorialMap(sigma, alpha)
    except InvalidMap:
        return None


def covering_walk(map_: CombinatorialMap, start: Dart) -> int:
    """The fewest traversals of a walk from the vertex of a dart along every edge, to any end.

    A walk goes along each edge once, and again along shortest paths between the vertices at which
    it would be stuck: those of odd degree, except for its two ends.

    Cost: that of a matching of these vertices, a fraction of a second for 100 of them.
    """
    import networkx as nx  # 'import allworlds' stays fast

    first = map_.vertex_of[start]
    # With the edges that are gone along again, all vertices but the two ends have even degree.
    # The end is free, so one of these stays without a partner: they are odd in number.
    odd = {vertex for vertex, degree in enumerate(map_.degrees) if degree % 2} ^ {first}
    alone = -1
    graph = nx.Graph()
    for vertex in sorted(odd):
        far = distances(map_, vertex)
        graph.add_weighted_edges_from((vertex, w, far[w]) for w in odd if w > vertex)
        graph.add_edge(vertex, alone, weight=0)
    again: int = sum(graph.edges[pair]["weight"] for pair in nx.min_weight_matching(graph))
    return map_.edge_count + again
