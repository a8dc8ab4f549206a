import re

import networkx as nx
import pytest

from allworlds.maps import (
    CombinatorialMap,
    InvalidMap,
    from_cycles,
    from_faces,
    from_networkx,
    from_rotation,
    isomorphism,
    named_map,
    networks,
    to_networkx,
)
from allworlds.maps.build import deleted, lattice
from allworlds.world import Directional, InvalidWorld, World
from bruteforce import rooted_maps_by_permutations


@pytest.mark.parametrize("name", ["edge", "loop", "theta", "k4-torus", "bouquet-3", "wheel-4"])
def test_the_graph_keeps_vertices_edges_ends_and_darts(name):
    map_ = named_map(name)
    graph = to_networkx(map_)
    assert isinstance(graph, nx.MultiGraph)
    again = map_.to_networkx()
    assert nx.utils.graphs_equal(again, graph)
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
    map_ = from_networkx(embedding)
    assert map_.genus == 0
    assert nx.is_isomorphic(nx.Graph(to_networkx(map_)), graph)


def test_darts_follow_the_clockwise_order_of_the_embedding():
    embedding = nx.PlanarEmbedding()
    embedding.set_data({0: [2, 1, 3, 4], 1: [0], 2: [0], 3: [0], 4: [0]})
    nodes = list(embedding)
    map_ = from_networkx(embedding)
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
    assert isomorphism(from_networkx(embedding), map_)


def test_an_embedding_that_is_empty_or_not_connected_is_refused():
    with pytest.raises(InvalidMap):
        from_networkx(nx.PlanarEmbedding())
    _, lonely = nx.check_planarity(nx.Graph([(0, 1), (1, 2)]))
    lonely.add_node(3)
    with pytest.raises(InvalidMap, match="vertex 3 has an empty list"):
        from_networkx(lonely)
    _, parted = nx.check_planarity(nx.Graph([(0, 1), (2, 3)]))
    with pytest.raises(InvalidMap, match="vertex 2 cannot be reached from vertex 0"):
        from_networkx(parted)


def torus_of_four(type_=nx.PlanarEmbedding):
    embedding = nx.PlanarEmbedding()
    embedding.set_data({v: [w for w in range(4) if w != v] for v in range(4)})
    return type_(embedding)


@pytest.mark.parametrize("type_", [nx.PlanarEmbedding, nx.DiGraph])
def test_an_embedding_of_any_genus_is_read(type_):
    map_ = from_networkx(torus_of_four(type_))
    assert map_.genus == 1
    assert isomorphism(map_, named_map("k4-torus"))


def test_every_small_map_comes_back_from_networkx():
    for m in (1, 2, 3):
        for map_ in rooted_maps_by_permutations(m):
            assert from_networkx(to_networkx(map_)) == map_


def test_a_world_becomes_a_graph_with_its_start_and_lighthouse():
    graph = World(named_map("theta-torus"), Directional(1), 2).to_networkx()
    assert graph.graph == {"start": 2, "lighthouse": {"kind": "directional", "dart": 1}}
    assert from_networkx(graph) == named_map("theta-torus")


@pytest.mark.parametrize("kind", ["none", "directional", "compass", "movable:markers=2", "labels"])
def test_a_world_comes_back_from_its_graph(kind):
    world = World(named_map("theta-torus"), kind, 2)
    assert World.from_networkx(world.to_networkx()) == world
    # What the graph says goes before the arguments, and a plain graph takes these.
    assert World.from_networkx(world.to_networkx(), "position", 5) == world
    bare = world.to_networkx()
    bare.graph.clear()
    assert World.from_networkx(bare, kind, 2) == world
    assert World.from_networkx(bare) == World(world.map, Directional(0), 0)


def test_a_graph_with_a_start_that_is_no_dart_is_refused():
    graph = World(named_map("theta"), "none").to_networkx()
    graph.graph["start"] = 6
    with pytest.raises(InvalidWorld, match="start = 6 is no dart"):
        World.from_networkx(graph)


def test_a_planar_graph_is_embedded_in_the_plane():
    map_ = from_networkx(nx.dodecahedral_graph(), order="planar")
    assert (map_.vertex_count, map_.edge_count, len(map_.faces), map_.genus) == (20, 30, 12, 0)


PLAIN = [
    nx.path_graph(2),
    nx.MultiGraph([("a", "b"), ("a", "b")]),
    nx.Graph([(0, 0), (0, 1)]),
    nx.path_graph(2).to_directed(),
    nx.triangular_lattice_graph(2, 2),  # with positions
    nx.random_geometric_graph(9, 2, seed=1),
]


@pytest.mark.parametrize("graph", PLAIN)
def test_a_graph_without_an_order_is_refused_and_told_the_ways(graph):
    with pytest.raises(InvalidMap, match="has no order of its edges") as refused:
        from_networkx(graph)
    first = next(iter(graph))
    ways = ["order='positions'", "order='planar'", "maps.from_rotation", "maps.from_cycles"]
    assert all(way in str(refused.value) for way in [f"node {first!r} has", *ways])


def ways(there, back):
    """A graph with an edge each way, which have these attributes."""
    return nx.DiGraph([(0, 1, there), (1, 0, back)])


@pytest.mark.parametrize(
    ("graph", "said"),
    [
        (nx.complete_graph(5), "the graph of node 0 is not planar; maps.from_rotation"),
        (nx.Graph(), "the graph has no node; a map has at least one edge"),
        (nx.DiGraph([("a", "b"), ("b", "a"), ("b", "c")]), "from 'b' to 'c' leads one way only"),
        (nx.MultiDiGraph([(0, 1), (1, 0), (1, 0)]), "the edge from 1 to 0 leads one way only"),
        (ways({"oneway": True}, {"oneway": True}), "the edge from 0 to 1 leads one way only"),
        (ways({"osmid": 1}, {"osmid": 2}), "the edge from 0 to 1 and that back have keys or ids"),
        (ways({"id": 1}, {}), "the edge from 0 to 1 and that back have keys or ids of their own"),
        # As networkx reads a file with ids, one pair of whose edges is parallel.
        (
            nx.MultiDiGraph([(0, 1, 7), (1, 0, 8), (1, 2, 1), (2, 1, 2), (1, 2, 3), (2, 1, 4)]),
            "the edge from 0 to 1 and that back have keys or ids of their own",
        ),
        (
            nx.MultiGraph([(0, 1), (0, 1)]),
            "the edge from 0 to 1 is a loop, or one of several; maps.from_rotation",
        ),
        (nx.Graph([(0, 1), (2, 3)]), "vertex 2 cannot be reached from vertex 0"),
        (nx.empty_graph(2), "node 0 has no edge"),
        ({0: [1], 1: [0]}, "{0: [1], 1: [0]} is no graph of networkx; maps.from_rotation"),
        ([(0, 1)], "[(0, 1)] is no graph of networkx; maps.from_rotation"),
    ],
)
@pytest.mark.parametrize("order", ["planar", "positions"])
def test_a_graph_that_an_order_does_not_fit_is_refused_by_its_place(graph, said, order):
    if isinstance(graph, nx.Graph):
        nx.set_node_attributes(graph, {v: (i, i * i) for i, v in enumerate(graph)}, "pos")
    if order == "positions" and "not planar" in said:
        assert from_networkx(graph, order).edge_count == 10
        return
    with pytest.raises(InvalidMap) as refused:
        from_networkx(graph, order)
    assert said in str(refused.value)


def test_an_order_that_is_asked_for_goes_before_that_of_the_graph():
    embedding = torus_of_four()
    nx.set_node_attributes(embedding, {0: (0, 0), 1: (0, 3), 2: (-3, -3), 3: (3, -3)}, "pos")
    inside = from_rotation([[1, 3, 2], [3, 0, 2], [1, 0, 3], [0, 1, 2]])
    assert isomorphism(from_networkx(embedding, "positions"), inside)
    assert from_networkx(embedding, "planar").genus == 0
    darts = to_networkx(named_map("k4-torus"))
    nx.set_node_attributes(darts, dict(embedding.nodes(data="pos")), "pos")
    assert isomorphism(from_networkx(darts, "positions"), inside)


def test_no_order_but_these_is_legal():
    with pytest.raises(InvalidMap, match="order = 'pos'; legal is 'positions', 'planar' or None"):
        from_networkx(nx.path_graph(2), "pos")


def test_attributes_that_are_no_darts_are_refused():
    graph = nx.Graph()
    graph.add_nodes_from([(0, {"darts": (0,)}), (1, {"darts": (2,)})])
    graph.add_edge(0, 1, darts=(0, 2))
    with pytest.raises(InvalidMap, match=r"the darts '?\[0, 2\]'? are not 0..1"):
        from_networkx(graph)


@pytest.mark.parametrize(
    ("edges", "said"),
    [
        ([(0, 0), (0, 1)], "the edge from 0 to 0 is a loop, or one of several; maps.from_rotation"),
        ([(0, 1), (1, 2), (2, 0), ("c", "c"), (2, "c")], "the edge from 'c' to 'c' is a loop"),
        ([(0, 0)], "the edge from 0 to 0 is a loop"),
    ],
)
def test_a_loop_of_a_plain_graph_is_refused(edges, said):
    with pytest.raises(InvalidMap, match=said):
        from_networkx(nx.Graph(edges), order="planar")


def k4(change):
    graph = to_networkx(named_map("k4"))
    return change(graph) or graph


def with_an_edge_moved(graph):
    graph.remove_edge(0, 1, 0)
    graph.add_edge(2, 3, key=0, darts=(0, 3))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            lambda g: g.add_edges_from([(0, 1)]) and None,
            "the edge from 0 to 1 has no attribute 'darts'",
        ),
        (
            lambda g: g.add_edges_from([(1, 1)]) and None,
            "the edge from 1 to 1 has no attribute 'darts'",
        ),
        (with_an_edge_moved, "the edge from 2 to 3 has the darts [0, 3]"),
        (lambda g: nx.contracted_nodes(g, 0, 1), "the edge from 0 to 2 has the darts [5, 7]"),
        (lambda g: g.remove_edge(0, 1), "no edge has dart 0 of node 0"),
        (lambda g: g.remove_node(3), "no edge has dart 2 of node 0"),
        (lambda g: g.add_node(4), "node 4 has no edge"),
        (lambda g: g.add_edge(3, 4, darts=(12, 13)), "node 4 has no attribute 'darts'"),
        (lambda g: nx.Graph(g.edges(data=True)), "node 0 has no attribute 'darts'"),
        (lambda g: g.add_node(3, darts=()), "node 3 has darts = ()"),
        (lambda g: g.add_node(3, darts="7, 10, 9"), "node 3 has darts = '7, 10, 9'"),
        (lambda g: g.add_node(3, darts=7), "node 3 has darts = 7"),
        (lambda g: g.add_node(3, darts=(1,)), "has the darts ["),
        (lambda g: g.edges[0, 1, 0].update(darts=(0, 3, 1)), "from 0 to 1 has the darts [0, 3, 1]"),
        (lambda g: g.edges[0, 1, 0].update(darts=(0, 99)), "from 0 to 1 has the darts [0, 99]"),
        (lambda g: g.edges[0, 1, 0].update(darts=(1, 3)), "the edge from 0 to 2 has the darts"),
    ],
)
def test_a_graph_that_was_changed_beside_its_darts_is_refused(change, said):
    with pytest.raises(InvalidMap, match=re.escape(said)):
        from_networkx(k4(change))


def test_parallel_edges_that_networkx_has_merged_are_refused():
    merged = nx.Graph(to_networkx(named_map("theta")))
    with pytest.raises(InvalidMap, match="no edge has dart 0 of node 0"):
        from_networkx(merged)


@pytest.mark.parametrize("name", ["k4", "theta-torus", "two-loops-torus", "bouquet-3", "dipole-4"])
def test_both_directions_of_an_edge_are_one_edge(name):
    map_ = named_map(name)
    assert from_networkx(to_networkx(map_).to_directed()) == map_


def test_darts_of_a_simple_map_may_stand_in_a_simple_graph():
    assert from_networkx(nx.Graph(to_networkx(named_map("k4")))) == named_map("k4")


# The always-on comparison, with a wrong importer for each kind of graph.


def without_the_last_edge(map_):
    return deleted(map_, map_.edges[-1][0])


GIVEN = {
    "positions": nx.grid_graph((5,)),
    "embedding": nx.check_planarity(nx.wheel_graph(5))[1],
    "darts": to_networkx(from_cycles(["a", "abb"])),
    "directed": to_networkx(from_cycles(["a", "abb"])).to_directed(),
}


nx.set_node_attributes(GIVEN["positions"], {v: (v, 0) for v in range(5)}, "pos")


@pytest.mark.parametrize("kind", GIVEN)
def test_an_importer_that_drops_an_edge_is_found_out(kind, monkeypatch):
    order = "positions" if kind == "positions" else None
    assert from_networkx(GIVEN[kind], order)
    drop = {
        "from_rotation": lambda rotation: without_the_last_edge(from_rotation(rotation)),
        "from_cycles": lambda cycles: without_the_last_edge(from_cycles(cycles)),
        "CombinatorialMap": lambda *pair: without_the_last_edge(CombinatorialMap(*pair)),
    }
    for name, wrong in drop.items():
        monkeypatch.setattr(networks, name, wrong)
    with pytest.raises(InvalidMap, match=r"edges from . to . is 1 in the graph, 0 in the map"):
        from_networkx(GIVEN[kind], order)


@pytest.mark.parametrize(
    ("cycles", "nodes", "said"),
    [
        ("ab ab", (0, 1), None),
        ("aab b", (0, 1), "from 0 to 1 is 2 in the graph, 1 in the map"),
        ("abcc ab", (0, 1), "from 0 to 0 is 0 in the graph, 1 in the map"),
        ("abc abc", (0, 1), "from 0 to 1 is 2 in the graph, 3 in the map"),
        ("ab a b", (0, 1, 1), "the graph has 2 nodes, but the map 3"),
    ],
)
def test_the_edges_of_the_map_are_compared_with_those_of_the_graph(cycles, nodes, said):
    map_, graph = from_cycles(cycles.split()), nx.MultiGraph([(0, 1), (0, 1)])
    if said is None:
        assert networks.compared(map_, nodes, graph) is map_
    else:
        with pytest.raises(InvalidMap, match=said):
            networks.compared(map_, nodes, graph)


def test_positions_beside_an_order_are_not_read():
    graph, embedding = to_networkx(named_map("k4-torus")), nx.check_planarity(nx.path_graph(3))[1]
    for given in (graph, embedding):
        nx.set_node_attributes(given, (0.0, 0.0), "pos")
    assert from_networkx(graph) == named_map("k4-torus")
    assert from_networkx(embedding).edge_count == 2


def star():
    embedding = nx.PlanarEmbedding()
    embedding.set_data({0: [1, 2, 3, 4], 1: [0], 2: [0], 3: [0], 4: [0]})
    return embedding


def two_cycles():
    embedding = star()
    for a, b in ((1, 2), (2, 1), (3, 4), (4, 3)):
        embedding[0][a]["cw"] = b
        embedding[0][b]["ccw"] = a
    return embedding


def never_back():
    embedding = star()
    embedding[0][4]["cw"] = 2  # 1, 2, 3, 4, 2, ...
    return embedding


def stale():
    embedding = nx.PlanarEmbedding()
    embedding.set_data({0: [1, 2, 3], 1: [2, 0], 2: [0, 1], 3: [0]})
    nx.DiGraph.remove_edge(embedding, 0, 2)
    nx.DiGraph.remove_edge(embedding, 2, 0)
    return embedding


def two_orders():
    embedding = star()
    for a, b in ((1, 3), (3, 2), (2, 4), (4, 1)):
        embedding[0][b]["ccw"] = a
    return embedding


@pytest.mark.parametrize(
    ("embedding", "vertex"),
    [
        (two_cycles(), 0),
        (never_back(), 0),
        (stale(), 0),
        (two_orders(), 0),
        (nx.PlanarEmbedding({1: {2: {}}, 2: {1: {}}}), 1),
        (nx.PlanarEmbedding({1: {3: {}}, 2: {1: {"cw": 1, "ccw": 1}}, 3: {1: {}}}), 1),
    ],
)
def test_pointers_that_are_no_order_are_refused_by_their_vertex(embedding, vertex):
    with pytest.raises(
        InvalidMap, match=f"at vertex {vertex} 'cw' and 'ccw' do not lead once round"
    ):
        from_networkx(embedding)


def test_an_edge_that_an_embedding_has_in_one_direction_is_refused():
    embedding = nx.PlanarEmbedding()
    embedding.set_data({0: [1, 2], 1: [0, 2], 2: [1]})
    with pytest.raises(InvalidMap, match="vertex 0 lists 2, but 2 does not list 0"):
        from_networkx(embedding)


# The tetrahedron; the torus of seven vertices (A. F. Moebius, 1861): i, i+1, i+3 and i, i+3, i+2.
TORUS = [((i, (i + 1) % 7, (i + 3) % 7), (i, (i + 3) % 7, (i + 2) % 7)) for i in range(7)]


@pytest.mark.parametrize(
    ("faces", "numbers"),
    [
        (["abc", "acd", "adb", "bdc"], (4, 6, 4, 0)),
        ([face for pair in TORUS for face in pair], (7, 21, 14, 1)),
        (["abc", "cba"], (3, 3, 2, 0)),
    ],
)
def test_a_surface_is_glued_of_its_faces(faces, numbers):
    map_ = from_faces(faces)
    found = (map_.vertex_count, map_.edge_count, len(map_.faces), map_.genus)
    assert found == numbers
    assert sorted(map(len, map_.faces)) == sorted(map(len, faces))


def test_the_faces_of_a_simple_map_give_it_back():
    map_ = named_map("k4")
    at = map_.vertex_of
    again = from_faces([[at[dart] for dart in face] for face in map_.faces])
    assert isomorphism(map_, again)


@pytest.mark.parametrize(
    ("faces", "said"),
    [
        (["abc"], "never walked back"),
        (["abc", "abc"], "from 'a' to 'b' is a loop or walked twice; from_cycles"),
        (["aa"], "from 'a' to 'a' is a loop or .*from_cycles"),
        (["abc", "acb", "ade", "aed"], "at vertex 'a' 2 pieces of surface meet"),
        (["abc", "acb", "dce", "dec", "cfg", "cgf"], "at vertex 'c' 3 pieces of surface meet"),
        (["abc", "acb", "def", "dfe"], "vertex 'd' cannot be reached from vertex 'a'; .*connected"),
    ],
)
def test_faces_that_close_no_surface_are_refused(faces, said):
    with pytest.raises(InvalidMap, match=said):
        from_faces(faces)


def test_two_corners_of_a_cube_glued_to_one_are_refused():
    map_ = named_map("cube")
    far = nx.single_source_shortest_path_length(to_networkx(map_), 0)
    glued = {corner: 0 if far[corner] == 3 else corner for corner in range(8)}
    faces = [[glued[map_.vertex_of[dart]] for dart in face] for face in map_.faces]
    with pytest.raises(InvalidMap, match=r"at vertex '?0'? 2 pieces of surface meet"):
        from_faces(faces)
