"""The clockwise order by positions."""

import math
from decimal import Decimal
from fractions import Fraction

import networkx as nx
import numpy as np
import pytest

from allworlds.maps import (
    InvalidMap,
    from_networkx,
    from_positions,
    from_rotation,
    isomorphism,
    named_map,
    unrooted_code,
)
from allworlds.maps.build import lattice

# A plan that is not its own mirror image: a triangle with a room at one of its corners outside, one
# inside, and a longer way behind the next corner clockwise.
PLAN = nx.Graph(["ab", "bc", "ca", "ax", "ai", "by", "yz"])
PLACES = {
    "a": (0, 0), "b": (4, 8), "c": (8, 0),
    "x": (-3, -1), "i": (4, 2), "y": (3, 12), "z": (0, 12),
}  # fmt: skip
CLOCKWISE = {
    "a": "bicx", "b": "yca", "c": "ab", "x": "a", "i": "a", "y": "bz", "z": "y",
}  # fmt: skip


def test_edges_are_taken_clockwise_and_up_is_up():
    map_ = from_positions(PLAN, PLACES)
    read = from_rotation({v: CLOCKWISE[v] for v in PLAN})
    assert isomorphism(map_, read)
    assert map_.genus == 0
    down = from_positions(PLAN, {v: (x, -y) for v, (x, y) in PLACES.items()})
    assert unrooted_code(down) == unrooted_code(map_.mirrored()) != unrooted_code(map_)


def test_darts_begin_straight_up_and_vertices_are_the_nodes_in_their_order():
    around = {"up": (0, 1), "right": (1, 0), "down": (0, -1), "left": (-1, 0)}
    graph = nx.Graph([("mid", side) for side in ("left", "down", "right", "up")])
    map_ = from_positions(graph, {"mid": (0, 0), **around})
    nodes = list(graph)
    assert [nodes[map_.vertex_of[map_.alpha[d]]] for d in map_.vertices[0]] == list(around)
    nx.set_node_attributes(graph, {"mid": (0, 0), **around}, "pos")
    assert from_networkx(graph, order="positions") == map_


def test_a_grid_on_its_places_is_the_lattice():
    graph = nx.grid_2d_graph(3, 4)
    assert from_positions(graph, {(r, c): (c, -r) for r, c in graph}) == lattice(3, 4)


def test_the_plan_decides_and_not_the_embedding_that_networkx_finds():
    # A square with a leaf at each of two corners: both outside, or one inside.
    graph = nx.Graph(["ab", "bc", "cd", "da", "ax", "by"])
    square = {"a": (0, 0), "b": (0, 4), "c": (4, 4), "d": (4, 0), "x": (-1, -1)}
    inside = from_positions(graph, {**square, "y": (1, 3)})
    outside = from_positions(graph, {**square, "y": (-1, 5)})
    assert [sorted(map(len, map_.faces)) for map_ in (inside, outside)] == [[6, 6], [4, 8]]


def test_lines_may_cross_and_the_genus_follows():
    assert from_positions(nx.complete_graph(4), nx.circular_layout(range(4))).genus == 1
    assert from_positions(nx.petersen_graph(), nx.shell_layout(nx.petersen_graph())).genus > 0


def test_every_type_of_graph_is_read_where_no_edges_are_parallel():
    map_ = from_positions(PLAN, PLACES)
    types = [nx.MultiGraph, nx.DiGraph, nx.MultiDiGraph]
    for type_ in types:
        assert from_positions(type_(PLAN), PLACES) == map_
    keyed = nx.MultiGraph()
    keyed.add_edges_from((v, w, f"door {i}") for i, (v, w) in enumerate(PLAN.edges))
    assert from_positions(keyed, PLACES) == map_


NUMBERS = [int, float, Fraction, Decimal, np.float64, np.float32, np.int64, np.int8]


@pytest.mark.parametrize("number", NUMBERS)
def test_numbers_of_every_type_are_read(number):
    pos = {v: (number(x), number(y)) for v, (x, y) in PLACES.items()}
    assert from_positions(PLAN, pos) == from_positions(PLAN, PLACES)
    arrays = {v: np.array(place) for v, place in pos.items()}
    assert from_positions(PLAN, arrays) == from_positions(PLAN, PLACES)


@pytest.mark.parametrize("far", [10**40, 1e-300, 1e300])
def test_directions_are_compared_exactly(far):
    # Angles that are one float.
    graph = nx.star_graph(3)
    pos = {0: (0, 0), 1: (10**20, 10**20 + 1), 2: (10**20, 10**20), 3: (far, -far)}
    assert math.atan2(*pos[1]) == math.atan2(*pos[2])
    around = [[1, 2, 3], [0], [0], [0]]
    assert from_positions(graph, pos) == from_rotation(around)
    around[0] = [2, 1, 3]
    assert from_positions(graph, {**pos, 1: pos[2], 2: pos[1]}) == from_rotation(around)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ((0.1, 0.2), (0.3, 0.6)),  # 3 * 0.1 is another float than 0.3
        ((10**20, 10**20), (1, 1)),
        ((0, 1), (0, 1e-9)),
        ((-3, 0), (-1, 0)),
        ((5, 5), (5, 5)),
    ],
)
def test_two_edges_in_one_direction_are_refused_by_name(first, second):
    graph = nx.Graph([("hall", "den"), ("hall", "bath")])
    with pytest.raises(InvalidMap) as refused:
        from_positions(graph, {"hall": (0, 0), "den": first, "bath": second})
    said = "the edges from 'hall' to 'den' and to 'bath' leave it in one direction; maps.from_rot"
    assert said in str(refused.value)


def test_opposite_directions_are_two():
    map_ = from_positions(nx.path_graph(3), {0: (0, 0), 1: (1, 1), 2: (2, 2)})
    assert isomorphism(map_, named_map("path-3"))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"i": None}, "node 'i' has the position None; legal are two finite numbers"),
        ({"i": (1,)}, "node 'i' has the position (1,)"),
        ({"i": (1, 2, 3)}, "node 'i' has the position (1, 2, 3)"),
        ({"i": (math.nan, 2)}, "node 'i' has the position (nan, 2)"),
        ({"i": (1, -math.inf)}, "node 'i' has the position (1, -inf)"),
        ({"i": "12"}, "node 'i' has the position '12'"),
        ({"i": ("1", "2")}, "node 'i' has the position ('1', '2')"),
        ({"i": (1, True)}, "node 'i' has the position (1, True)"),
        ({"i": {"x": 1, "y": 2}}, "node 'i' has the position {'x': 1, 'y': 2}"),
        ({"i": 7}, "node 'i' has the position 7"),
        ({"i": np.zeros((2, 2))}, "node 'i' has the position array([[0., 0.],"),
        ({"i": (0, 0)}, "the nodes 'a' and 'i' are joined, but at one place"),
    ],
)
def test_places_that_are_none_are_refused_by_their_node(change, said):
    with pytest.raises(InvalidMap) as refused:
        from_positions(PLAN, {**PLACES, **change})
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("edges", "said"),
    [
        (
            [("a", "b"), ("b", "b")],
            "the edge from 'b' to 'b' is a loop, or one of several; maps.",
        ),
        (
            [("a", "b"), ("a", "b")],
            "the edge from 'a' to 'b' is a loop, or one of several; maps.",
        ),
        ([("a", "b"), ("c", "x")], "vertex 'c' cannot be reached from vertex 'a'"),
    ],
)
def test_what_lines_do_not_show_is_refused(edges, said):
    with pytest.raises(InvalidMap, match=said):
        from_positions(nx.MultiGraph(edges), PLACES)


def test_a_node_without_a_place_or_without_an_edge_is_named():
    graph = nx.Graph(PLAN)
    graph.add_node("cellar")
    with pytest.raises(InvalidMap, match="node 'cellar' has no edge"):
        from_positions(graph, PLACES)
    graph.add_edge("cellar", "a")
    with pytest.raises(InvalidMap, match="node 'cellar' has the position None"):
        from_positions(graph, PLACES)


def test_two_nodes_that_are_not_joined_may_be_at_one_place():
    graph = nx.Graph(["ab", "bc", "cd"])
    pos = {"a": (0, 0), "b": (1, 0), "c": (1, 1), "d": (0, 0)}
    assert isomorphism(from_positions(graph, pos), named_map("path-4"))
