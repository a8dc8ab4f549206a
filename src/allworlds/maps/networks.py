"""Maps to and from networkx."""

from __future__ import annotations

from typing import TYPE_CHECKING

from allworlds.maps.build import from_rotation
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap

if TYPE_CHECKING:
    import networkx as nx


def to_networkx(map_: CombinatorialMap) -> nx.MultiGraph:
    """The graph of the map; the rotation is forgotten.

    Its nodes are the vertices ``0..n-1``; the edge of darts ``d < e`` has the key ``d`` and
    the attribute ``darts=(d, e)``, with ``d`` at the end that is named first.
    """
    import networkx as nx  # 'import allworlds' stays fast

    graph = nx.MultiGraph()
    graph.add_nodes_from(range(map_.vertex_count))
    owner = map_.vertex_of
    for d, e in map_.edges:
        graph.add_edge(owner[d], owner[e], key=d, darts=(d, e))
    return graph


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
