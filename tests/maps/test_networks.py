import networkx as nx
import pytest

from allworlds.maps import (
    InvalidMap,
    from_cycles,
    from_planar_embedding,
    isomorphism,
    lattice,
    named_map,
    to_networkx,
)


@pytest.mark.parametrize("name", ["edge", "loop", "theta", "k4-torus", "bouquet-3", "wheel-4"])
def test_the_graph_keeps_vertices_edges_ends_and_darts(name):
    map_ = named_map(name)
    graph = to_networkx(map_)
    assert isinstance(graph, nx.MultiGraph)
    assert list(graph) == list(range(map_.vertex_count))
    assert sorted(graph.edges(keys=True, data="darts"), key=lambda edge: edge[2]) == [
        (map_.vertex_of[d], map_.vertex_of[e], d, (d, e))
        for d, e in map_.edges
    ]  # fmt: skip
    assert tuple(degree for _, degree in graph.degree()) == map_.degrees


def test_a_loop_and_parallel_edges_stay_apart():
    graph = to_networkx(from_cycles(["aabc", "bc"]))
    assert graph.number_of_edges(0, 0) == 1
    assert graph.number_of_edges(0, 1) == 2


@pytest.mark.parametrize("name", ["k4", "wheel-5", "cube", "path-4", "fig1-left"])
def test_a_planar_embedding_keeps_its_graph_and_has_genus_zero(name):
    graph = nx.Graph(to_networkx(named_map(name)))
    planar, embedding = nx.check_planarity(graph)
    assert planar
    map_ = from_planar_embedding(embedding)
    assert map_.genus == 0
    assert nx.is_isomorphic(nx.Graph(to_networkx(map_)), graph)


def test_darts_follow_the_clockwise_order_of_the_embedding():
    embedding = nx.PlanarEmbedding()
    embedding.set_data({0: [2, 1, 3, 4], 1: [0], 2: [0], 3: [0], 4: [0]})
    nodes = list(embedding)
    map_ = from_planar_embedding(embedding)
    hub = nodes.index(0)
    around = [nodes[map_.vertex_of[map_.alpha[d]]] for d in map_.vertices[hub]]
    first = around.index(2)
    assert around[first:] + around[:first] == [2, 1, 3, 4]


def test_a_map_written_as_an_embedding_and_read_back_is_the_same():
    map_ = lattice(3, 4, holes=0.2, seed=1)
    embedding = nx.PlanarEmbedding()
    embedding.set_data(
        {v: [map_.vertex_of[map_.alpha[d]] for d in darts] for v, darts in enumerate(map_.vertices)}
    )
    assert isomorphism(from_planar_embedding(embedding), map_)


def test_an_embedding_that_is_empty_or_not_connected_is_refused():
    with pytest.raises(InvalidMap):
        from_planar_embedding(nx.PlanarEmbedding())
    _, lonely = nx.check_planarity(nx.Graph([(0, 1), (1, 2)]))
    lonely.add_node(3)
    with pytest.raises(InvalidMap, match="vertex 3 has an empty list"):
        from_planar_embedding(lonely)
    _, parted = nx.check_planarity(nx.Graph([(0, 1), (2, 3)]))
    with pytest.raises(InvalidMap, match="vertex 2 cannot be reached from vertex 0"):
        from_planar_embedding(parted)


def test_an_embedding_that_is_not_in_the_plane_is_refused():
    embedding = nx.PlanarEmbedding()
    embedding.set_data({v: [w for w in range(4) if w != v] for v in range(4)})
    with pytest.raises(InvalidMap, match="genus 1"):
        from_planar_embedding(embedding)
