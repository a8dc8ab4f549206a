"""Maps to and from networkx."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from allworlds.inputs.checks import integer, show
from allworlds.maps.build import from_rotation, map_at
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap, cycles

if TYPE_CHECKING:
    import networkx as nx


def to_networkx(map_: CombinatorialMap) -> nx.MultiGraph:
    """The graph of the map; its rotation stands in attributes.

    Its nodes are the vertices ``0..n-1``, each with its darts clockwise as the attribute
    ``darts``; the edge of darts ``d < e`` has the key ``d`` and the attribute ``darts=(d, e)``,
    with ``d`` at the end that is named first.  :func:`from_networkx` takes it back.
    """
    import networkx as nx  # 'import allworlds' stays fast

    graph = nx.MultiGraph()
    graph.add_nodes_from((v, {"darts": darts}) for v, darts in enumerate(map_.vertices))
    owner = map_.vertex_of
    for d, e in map_.edges:
        graph.add_edge(owner[d], owner[e], key=d, darts=(d, e))
    return graph


def from_networkx(graph: nx.Graph) -> CombinatorialMap:
    """The map of a graph of networkx.

    A graph of :func:`to_networkx` gives its map back, as long as the attributes ``darts`` are
    there.  A planar embedding gives its map of genus 0; a planar graph without loops and parallel
    edges, the map of the embedding that :func:`networkx.check_planarity` finds.  Other graphs have
    no rotation, and are refused; so are nodes with the attribute ``pos`` and without an order.

    Raises:
        InvalidMap: if the attributes are no map, or if the graph has no rotation, is not
            connected or has no edge, or if the map would not have all its edges.

    Cost: O(m).
    """
    import networkx as nx

    if isinstance(graph, nx.PlanarEmbedding):
        return from_planar_embedding(graph)
    attributes = [*graph.nodes(data=True), *graph.edges(data=True)]
    if any("darts" in data for *_, data in attributes):
        return _from_darts(graph.to_undirected() if graph.is_directed() else graph)
    for v, data in graph.nodes(data=True):
        if "pos" in data:
            raise InvalidMap(
                f"node {show(v)} has the attribute 'pos', which is not read as the order of its "
                "edges; maps.from_rotation and maps.from_cycles take an order, and without 'pos' "
                "networkx's own planar embedding is taken"
            )
    if graph.is_directed() or graph.is_multigraph():
        raise InvalidMap(
            f"a {type(graph).__name__} without the attribute 'darts' at each node has no rotation; "
            "an undirected planar graph without parallel edges is embedded in the plane"
        )
    for v in nx.nodes_with_selfloops(graph):
        raise InvalidMap(f"node {show(v)} has an edge to itself; maps.from_cycles takes loops")
    planar, embedding = nx.check_planarity(graph)
    if not planar:
        raise InvalidMap(
            "the graph is not planar, and no node has the attribute 'darts', its darts clockwise"
        )
    return _compared(from_planar_embedding(embedding), list(embedding), graph)


def _compared(map_: CombinatorialMap, nodes: Sequence[Any], graph: nx.Graph) -> CombinatorialMap:
    """The map, whose vertices are these nodes.

    Raises:
        InvalidMap: unless the map has the edges of the graph, with the same ends, and its nodes.
    """
    import networkx as nx

    place = {v: i for i, v in enumerate(graph)}
    at = [nodes[vertex] for vertex in map_.vertex_of]
    given = [tuple(sorted(ends, key=place.__getitem__)) for ends in graph.edges()]
    if isinstance(graph, nx.PlanarEmbedding):
        given = list(dict.fromkeys(given))  # it has each edge in both directions
    made = [tuple(sorted((at[d], at[e]), key=place.__getitem__)) for d, e in map_.edges]
    wanted, found = Counter(given), Counter(made)
    for ends in [*given, *made]:
        if wanted[ends] != found[ends]:
            v, w = map(show, ends)
            numbers = f"{wanted[ends]} in the graph, {found[ends]} in the map"
            raise InvalidMap(f"the number of edges from {v} to {w} is {numbers}")
    if map_.vertex_count != len(graph):
        raise InvalidMap(f"the graph has {len(graph)} nodes, but the map {map_.vertex_count}")
    return map_


def _from_darts(graph: nx.Graph) -> CombinatorialMap:
    """The map that the attributes ``darts`` of nodes and edges describe."""
    around = {v: _darts(f"node {show(v)}", data) for v, data in graph.nodes(data=True)}
    owner: dict[int, Hashable] = {}
    for v, darts in around.items():
        for dart in darts:
            if dart in owner:
                raise InvalidMap(f"dart {dart} is at the nodes {show(owner[dart])} and {show(v)}")
            owner[dart] = v
    pairs, loose = [], dict(owner)
    for v, w, data in graph.edges(data=True):
        edge = f"the edge from {show(v)} to {show(w)}"
        pair = _darts(edge, data)
        if len(pair) != 2 or Counter(loose.pop(dart, None) for dart in pair) != Counter((v, w)):
            legal = "an edge has two darts of its own, one at each end"
            raise InvalidMap(f"{edge} has the darts {show(pair)}; {legal}")
        pairs.append(pair)
    if loose:
        some = ", nor ".join(f"dart {d} of node {show(v)}" for d, v in [*loose.items()][:2])
        raise InvalidMap(f"no edge has {some}; each dart belongs to an edge")
    map_ = CombinatorialMap(_permutation(around.values()), _permutation(pairs))
    return _compared(map_, [owner[first] for first, *_ in map_.vertices], graph)


def _darts(place: str, data: Mapping[str, Any]) -> list[int]:
    """The darts of the node or edge with these attributes; one at least."""
    if "darts" not in data:
        raise InvalidMap(f"{place} has no attribute 'darts'; all nodes and edges have it, or none")
    try:
        darts = [integer(dart) for dart in data["darts"]]
    except TypeError:
        darts = []
    if not darts:
        raise InvalidMap(f"{place} has darts = {show(data['darts'])}; legal is a list of integers")
    return darts


def _permutation(cycles: Iterable[Sequence[int]]) -> list[int]:
    """The images of the permutation with these cycles, by the numbers that are moved.

    Raises:
        InvalidMap: unless each of 0..N-1 stands in one cycle.
    """
    image = {a: b for cycle in cycles for a, b in zip(cycle, [*cycle[1:], *cycle[:1]], strict=True)}
    if sorted(image) != list(range(len(image))):
        raise InvalidMap(f"the darts {show(sorted(image))} are not 0..{len(image) - 1}")
    return [image[dart] for dart in range(len(image))]


def from_faces(faces: Sequence[Sequence[Hashable]]) -> CombinatorialMap:
    """The map of a closed surface that is glued of polygons.

    Args:
        faces: of each face the vertices in the order of its walk, such as ``"abc"``; each edge is
            walked once in each direction.  Darts are numbered in this order, each at the vertex
            where it begins.  Two vertices are joined by one edge at most, and no vertex to itself:
            :func:`~allworlds.maps.build.from_cycles` takes parallel edges and loops, too.

    Raises:
        InvalidMap: naming an edge that is not walked so, a vertex at which two pieces meet, or
            one that no walk along edges reaches.

    Cost: O(m).
    """
    phi: dict[tuple[Hashable, Hashable], tuple[Hashable, Hashable]] = {}
    for face in faces:
        walk = list(zip(face, [*face[1:], *face[:1]], strict=True))
        for way, after in zip(walk, [*walk[1:], *walk[:1]], strict=True):
            a, b = way
            if a == b:
                raise InvalidMap(
                    f"vertex {show(a)} has a loop, whose two ends have one name here; from_cycles "
                    "takes loops"
                )
            if way in phi:
                raise InvalidMap(
                    f"the edge from {show(a)} to {show(b)} is walked twice; parallel edges have no "
                    "names here, from_cycles takes them"
                )
            phi[way] = after
    for a, b in phi:
        if (b, a) not in phi:
            raise InvalidMap(f"the edge from {show(a)} to {show(b)} is never walked back")
    number = {way: i for i, way in enumerate(phi)}
    # phi = sigma . alpha, so that sigma = phi . alpha.
    alpha = [number[b, a] for a, b in phi]
    sigma = [number[phi[b, a]] for a, b in phi]
    ways = list(phi)
    pieces = Counter(ways[around[0]][0] for around in cycles(sigma))
    for vertex, count in pieces.most_common(1):
        if count > 1:
            raise InvalidMap(f"at vertex {show(vertex)} {count} pieces of surface meet; 1 is legal")
    return map_at(sigma, alpha, [vertex for vertex, _ in ways])


def from_planar_embedding(embedding: nx.PlanarEmbedding) -> CombinatorialMap:
    """The map of genus 0 that an embedding of networkx describes.

    Darts are numbered node by node in the order of the embedding, clockwise round each.
    The embeddings of :func:`networkx.check_planarity` have no loops and no parallel edges.

    Raises:
        InvalidMap: if the embedding is empty, not connected, or not in the plane; or naming the
            node whose ``cw`` and ``ccw`` are no order of its neighbours.

    Cost: O(m).
    """
    map_ = from_rotation({v: _clockwise(v, around) for v, around in embedding.adjacency()})
    if map_.genus:
        raise InvalidMap(f"the embedding has genus {map_.genus}; a planar one has genus 0")
    return _compared(map_, list(embedding), embedding)


def _clockwise(v: Hashable, around: Mapping[Hashable, Mapping[str, Any]]) -> list[Hashable]:
    """The neighbours of ``v`` clockwise, as ``PlanarEmbedding.neighbors_cw_order`` begins."""
    following = {w: data.get("cw") for w, data in around.items()}
    first = w = next(reversed(following), None)
    walk = []
    while w in following:
        walk.append(w)
        w = following.pop(w)
    back = all(around[b].get("ccw", a) == a for a, b in pairwise([*walk, *walk[:1]]))
    if following or w != first or not back:
        once = f"once round its neighbours {show([*around])}"
        raise InvalidMap(f"at vertex {show(v)} 'cw' and 'ccw' do not lead {once}")
    return walk
