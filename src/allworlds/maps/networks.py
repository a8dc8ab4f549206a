"""Maps to and from networkx."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Sequence
from typing import TYPE_CHECKING

from allworlds.inputs import show
from allworlds.maps.build import ensure_connected, from_rotation
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
    there.  A planar embedding, or a planar graph without loops and parallel edges, gives a map of
    genus 0; other graphs have no rotation, and are refused.

    Raises:
        InvalidMap: if the attributes are no map, or if the graph has no rotation, is not
            connected or has no edge.

    Cost: O(m).
    """
    import networkx as nx

    if isinstance(graph, nx.PlanarEmbedding):
        return from_planar_embedding(graph)
    around = [data.get("darts") for _, data in graph.nodes(data=True)]
    if around and None not in around:
        edges = [data.get("darts", ()) for _, _, data in graph.edges(data=True)]
        return CombinatorialMap(_permutation(around), _permutation(edges))
    if graph.is_directed() or graph.is_multigraph():
        raise InvalidMap(
            f"a {type(graph).__name__} without the attribute 'darts' at each node has no rotation; "
            "an undirected planar graph without parallel edges is embedded in the plane"
        )
    planar, embedding = nx.check_planarity(graph)
    if not planar:
        raise InvalidMap(
            "the graph is not planar, and no node has the attribute 'darts', its darts clockwise"
        )
    return from_planar_embedding(embedding)


def _permutation(cycles: Iterable[Sequence[int]]) -> list[int]:
    """The images of the permutation with these cycles, by the numbers that are moved.

    Raises:
        InvalidMap: unless each of 0..N-1 stands in one cycle, once.
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
    ensure_connected([*pieces], ways)
    return CombinatorialMap(sigma, alpha)


def from_planar_embedding(embedding: nx.PlanarEmbedding) -> CombinatorialMap:
    """The map of genus 0 that an embedding of networkx describes.

    Darts are numbered node by node in the order of the embedding, clockwise round each.
    The embeddings of :func:`networkx.check_planarity` have no loops and no parallel edges.

    Raises:
        InvalidMap: if the embedding is empty, not connected, or not in the plane.

    Cost: O(m).
    """
    map_ = from_rotation({v: list(embedding.neighbors_cw_order(v)) for v in embedding})
    if map_.genus:
        raise InvalidMap(f"the embedding has genus {map_.genus}; a planar one has genus 0")
    return map_
