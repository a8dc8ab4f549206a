import itertools
import random

import networkx as nx
import pytest

from allworlds.maps import (
    CombinatorialMap,
    InvalidMap,
    automorphisms,
    build,
    from_cycles,
    from_rotation,
    isomorphism,
    named_map,
    named_maps,
)
from allworlds.maps.build import cycle, dense, lattice
from bruteforce import rooted_maps_by_permutations

# Vertices, edges and face lengths of well-known embedded graphs: the Platonic solids K4 and
# cube and the wheels from any textbook; the others counted by hand with Euler's formula.
KNOWN = {
    "edge": (2, 1, [2], 0),
    "loop": (1, 1, [1, 1], 0),
    "two-loops-plane": (1, 2, [1, 1, 2], 0),
    "two-loops-torus": (1, 2, [4], 1),
    "theta": (2, 3, [2, 2, 2], 0),
    "theta-torus": (2, 3, [6], 1),
    "dipole-1": (2, 1, [2], 0),
    "dipole-4": (2, 4, [2, 2, 2, 2], 0),
    "k4": (4, 6, [3, 3, 3, 3], 0),
    "k4-torus": (4, 6, [4, 8], 1),
    "k33": (6, 9, [6, 6, 6], 1),
    "k5": (5, 10, [5, 5, 10], 2),
    "petersen": (10, 15, [5, 12, 13], 2),
    "wheel-3": (4, 6, [3, 3, 3, 3], 0),
    "wheel-4": (5, 8, [3, 3, 3, 3, 4], 0),
    "cube": (8, 12, [4, 4, 4, 4, 4, 4], 0),
    "path-2": (2, 1, [2], 0),
    "path-5": (5, 4, [8], 0),
    "star-1": (2, 1, [2], 0),
    "star-4": (5, 4, [8], 0),
    "cycle-1": (1, 1, [1, 1], 0),
    "cycle-2": (2, 2, [2, 2], 0),
    "cycle-6": (6, 6, [6, 6], 0),
    "bouquet-1": (1, 1, [1, 1], 0),
    "bouquet-3": (1, 3, [1, 1, 1, 3], 0),
    # Vertices, edges and genus of the pair: nine vertices, fourteen edges, planar (n - m + f = 2).
    "fig1-left": (9, 14, [3, 3, 4, 4, 4, 4, 6], 0),
    "fig1-right": (9, 14, [3, 3, 3, 3, 4, 4, 8], 0),
}


@pytest.mark.parametrize("name", KNOWN)
def test_a_named_map_has_the_known_vertices_edges_faces_and_genus(name):
    map_ = named_map(name)
    faces = sorted(len(face) for face in map_.faces)
    assert (map_.vertex_count, map_.edge_count, faces, map_.genus) == KNOWN[name]
    CombinatorialMap(map_.sigma, map_.alpha)  # the law holds


def test_every_listed_name_is_known_above_and_the_list_is_sorted():
    tried = {name if name in named_maps() else name.rpartition("-")[0] + "-N" for name in KNOWN}
    assert tried == set(named_maps())
    assert list(named_maps()) == sorted(named_maps())


@pytest.mark.parametrize(
    ("name", "orientation_preserving"),
    # Rotation groups: A4 and S4 of the solids; dihedral or cyclic of the rest.
    [("k4", 12), ("cube", 24), ("wheel-5", 5), ("dipole-4", 8), ("cycle-7", 14), ("star-4", 4)],
)
def test_a_named_map_has_its_rotation_group(name, orientation_preserving):
    assert automorphisms(named_map(name)) == orientation_preserving


def test_the_hub_comes_first():
    assert named_map("wheel-4").degrees == (4, 3, 3, 3, 3)
    assert named_map("star-3").degrees == (3, 1, 1, 1)


# Source: the caption of Fig. 1 of the paper.
@pytest.mark.parametrize("name", ["fig1-left", "fig1-right"])
@pytest.mark.parametrize("start", range(4))
def test_the_walk_of_fig_1_sees_degree_three_four_times_and_comes_home(name, start):
    map_ = named_map(name)
    assert map_.degrees == (4, 3, 3, 3, 3, 3, 3, 3, 3)
    dart, seen = start, []
    for motion in (1, 1, 2, 2, 1):
        dart = map_.alpha[map_.turn(dart, motion)]
        seen.append((map_.degree_at[dart], map_.vertex_of[dart] == 0))
    assert seen == [(3, False)] * 4 + [(4, True)]


def test_the_maps_of_fig_1_are_simple_and_differ():
    left, right = named_map("fig1-left"), named_map("fig1-right")
    assert left.is_simple
    assert right.is_simple
    assert isomorphism(left, right) is None


@pytest.mark.parametrize("name", ["", "moon", "wheel", "k4-N", "edge-3", "-4"])
def test_an_unknown_name_is_refused_with_the_legal_ones(name):
    with pytest.raises(ValueError, match="no map is called") as refusal:
        named_map(name)
    assert repr(name) in str(refusal.value)
    assert all(legal in str(refusal.value) for legal in named_maps())


@pytest.mark.parametrize(
    ("name", "least"),
    [("wheel-2", 3), ("wheel-", 3), ("wheel-x", 3), ("cycle-0", 1), ("path-1", 2), ("star-²", 1)],
)
def test_a_size_that_is_no_size_is_refused_in_one_line(name, least):
    with pytest.raises(ValueError, match=f"needs an integer N >= {least}") as refusal:
        named_map(name)
    assert "\n" not in str(refusal.value)


def test_darts_are_numbered_vertex_by_vertex_in_the_order_given():
    map_ = from_rotation({"b": ["c", "a"], "a": ["b"], "c": ["b"]})
    # b: darts 0 (to c) and 1 (to a); a: dart 2; c: dart 3.
    assert map_.sigma == (1, 0, 2, 3)
    assert map_.alpha == (3, 2, 1, 0)


def test_a_list_of_lists_is_the_rotation_of_vertices_0_1_and_on():
    lists = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]]
    assert from_rotation(lists) == from_rotation(dict(enumerate(lists)))


def test_keys_tell_loops_and_parallel_edges():
    hall = [["a", 0], ["a", 1], ["hall", "x"], ["hall", "y"], ["hall", "x"], ["hall", "y"]]
    map_ = from_rotation({"hall": hall, "a": [["hall", 0], ["hall", 1]]})
    assert map_ == from_cycles(["01xyxy", "01"])
    assert from_rotation([[0, 0, 1], [0]]) == from_cycles(["aab", "b"])
    nan = float("nan")  # a name that is not equal to itself
    assert from_rotation({nan: [nan, nan]}) == named_map("loop")
    # The same neighbours, with the keys the other way round: another surface.
    crossed = {v: [["b" if v == "a" else "a", k] for k in (0, 1, 2)] for v in "ab"}
    assert from_rotation(crossed) == named_map("theta-torus")
    assert from_rotation({**crossed, "b": crossed["b"][::-1]}) == named_map("theta")


def test_a_tuple_is_a_name():
    assert from_rotation({(0, 1): [(1, 0)], (1, 0): [(0, 1)]}) == named_map("edge")


def test_every_small_map_can_be_written_with_keys():
    for m in (1, 2, 3):
        for map_ in rooted_maps_by_permutations(m):
            at = [(map_.vertex_of[d], min(d, map_.alpha[d])) for d in map_.darts]
            keyed = from_rotation(
                [[[at[map_.alpha[d]][0], at[d][1]] for d in darts] for darts in map_.vertices]
            )
            assert isomorphism(keyed, map_)


def test_edge_names_tell_loops_and_parallel_edges():
    map_ = from_cycles([["a", "a", "b"], ["b"]])
    assert map_.sigma == (1, 2, 0, 3)
    assert map_.alpha == (1, 0, 3, 2)


def test_both_notations_give_the_same_map_of_a_simple_graph():
    by_neighbours = from_rotation([[1, 2], [2, 0], [0, 1]])
    assert by_neighbours == from_cycles([["x", "y"], ["z", "x"], ["y", "z"]])


def test_every_map_can_be_written_with_edge_names():
    for sigma in itertools.permutations(range(4)):
        try:
            map_ = CombinatorialMap(sigma, (1, 0, 3, 2))
        except InvalidMap:
            continue
        names = [[dart // 2 for dart in vertex] for vertex in map_.vertices]
        assert isomorphism(from_cycles(names), map_)


@pytest.mark.parametrize(
    ("rotation", "named"),
    [
        ([[1, 1], [0, 0]], ["vertex 0 lists 1 2 times", "keys, as in [1, 0]"]),
        ([[0, 0, 0, 0]], ["vertex 0 lists 0 4 times", "keys, as in [0, 0]"]),
        ([[0]], ["vertex 0 lists 0 1 time; a loop stands twice"]),
        ({"a": [["b", 0]], "b": ["a"]}, ["lists ['b', 0], but 'b' does not list ['a', 0]"]),
        ({"a": [["b", 0]], "b": [["a", 1]]}, ["lists ['b', 0], but 'b' does not list ['a', 0]"]),
        ({"a": [["b", 0, 1]], "b": ["a"]}, ["'a' lists ['b', 0, 1]; legal is a neighbour, or ["]),
        ({"a": [["b", {}]], "b": ["a"]}, ["vertex 'a' lists {}, which cannot be a name"]),
        ([[1], [0, 2], []], ["vertex 2 has an empty list", "at least one edge"]),
        ([[1, 2], [0], [1]], ["vertex 0 lists 1", "vertex 0 lists 2"]),
        ({"a": ["b"], "b": ["a", "c"], "c": []}, ["vertex 'c' has an empty list"]),
        ({"a": ["b"], "b": ["d"]}, ["vertex 'a' lists 'b', but 'b' does not list 'a'"]),
        ({"a": ["d"], "b": ["a"]}, ["vertex 'a' lists 'd'; the vertices are ['a', 'b']"]),
        ([[1], [0], [3], [2]], ["vertex 2 cannot be reached from vertex 0"]),
        ({0: {1}, 1: {0}}, ["vertex 0 must have a clockwise list, not {1}"]),
        ([1, 0], ["vertex 0 must have a clockwise list, not 1"]),
        ([[[1]], [0]], ["vertex 0 lists [1]; legal is a neighbour, or [neighbour, key]"]),
        ([], ["m >= 1"]),
    ],
)
def test_what_is_no_rotation_is_refused_with_its_vertex(rotation, named):
    with pytest.raises(InvalidMap) as refusal:
        from_rotation(rotation)
    assert any(words in str(refusal.value) for words in named)
    if "from_cycles" in named:
        assert all(words in str(refusal.value) for words in named)


@pytest.mark.parametrize(
    ("vertices", "named"),
    [
        ([["a"], ["a", "b"]], "edge 'b' has 1 ends; every name must stand exactly twice"),
        ([["a", "a"], ["a"]], "edge 'a' has 3 ends"),
        ([["a", "a"], []], "vertex 1 has an empty list"),
        ({"hall": "aa", "den": "bb"}, "vertex 'den' cannot be reached from vertex 'hall'"),
        ([["a", "a"], ["b", "b"]], "vertex 1 cannot be reached from vertex 0"),
        ([7], "vertex 0 must have a clockwise list, not 7"),
        ([[["a"]]], r"vertex 0 lists \['a'\], which cannot be a name"),
        ([], "m >= 1"),
    ],
)
def test_what_are_no_cycles_is_refused_with_its_edge_or_vertex(vertices, named):
    with pytest.raises(InvalidMap, match=named):
        from_cycles(vertices)


@pytest.mark.parametrize(("rows", "columns"), [(1, 2), (2, 1), (3, 4), (5, 5)])
def test_a_lattice_is_planar_with_square_faces(rows, columns):
    map_ = lattice(rows, columns)
    assert map_.vertex_count == rows * columns
    assert map_.edge_count == rows * (columns - 1) + (rows - 1) * columns
    squares = sum(len(face) == 4 for face in map_.faces)
    assert map_.genus == 0
    assert squares >= (rows - 1) * (columns - 1) == len(map_.faces) - 1


def test_a_lattice_turns_up_right_down_left():
    map_ = lattice(3, 3)
    around_the_centre = map_.vertices[4]
    assert [map_.vertex_of[map_.alpha[d]] for d in around_the_centre] == [1, 5, 7, 3]


def test_a_dense_map_without_holes_is_complete_in_ascending_order():
    map_ = dense(5)
    assert map_.is_simple
    for v, darts in enumerate(map_.vertices):
        assert [map_.vertex_of[map_.alpha[d]] for d in darts] == [w for w in range(5) if w != v]


@pytest.mark.parametrize("seed", range(20))
def test_holes_remove_the_asked_number_of_edges_and_keep_every_vertex(seed):
    # 5 x 6: 49 edges, 0.1 of them rounded is 5; K9: 36 edges, 4.
    grid, complete = lattice(5, 6, 0.1, seed), dense(9, 0.1, seed)
    assert (grid.vertex_count, grid.edge_count) == (30, 44)
    assert (complete.vertex_count, complete.edge_count) == (9, 32)
    assert grid.genus == 0


def ends(map_):
    return [(map_.vertex_of[d], map_.vertex_of[e]) for d, e in map_.edges]


def test_holes_are_fixed_by_the_seed_and_differ_between_seeds():
    assert lattice(4, 4, 0.2, 7) == lattice(4, 4, 0.2, 7)
    assert len({tuple(ends(lattice(4, 4, 0.2, seed))) for seed in range(10)}) > 1


def test_more_holes_of_one_seed_only_remove_more_edges():
    few, many = ends(dense(7, 0.2, 3)), ends(dense(7, 0.5, 3))
    assert set(many) < set(few)


@pytest.mark.parametrize("seed", range(10))
def test_holes_are_the_first_edges_of_a_shuffle_that_are_no_bridge_in_their_turn(seed):
    whole = ends(dense(6))
    order = list(whole)
    random.Random(seed).shuffle(order)
    graph = nx.Graph(whole)
    for edge in order:
        if graph.number_of_edges() > 7 and edge not in set(nx.bridges(graph)):
            graph.remove_edge(*edge)
    # K6 has 15 edges; 8 go.
    assert set(ends(dense(6, 8 / 15, seed))) == {tuple(sorted(edge)) for edge in graph.edges}


def test_every_edge_that_is_no_bridge_can_be_the_first_to_go():
    whole = set(ends(dense(4)))
    gone = {next(iter(whole - set(ends(dense(4, 1 / 6, seed))))) for seed in range(100)}
    assert gone == whole


def test_as_many_holes_as_leave_a_tree_are_possible_and_no_more():
    # 3 x 3: 12 edges, a spanning tree has 8.
    assert lattice(3, 3, 4 / 12).edge_count == 8
    with pytest.raises(ValueError, match="would remove 5 of 12 edges, but at most 4 can go"):
        lattice(3, 3, 5 / 12)


@pytest.mark.parametrize("holes", [-0.1, 1.1, float("nan")])
def test_holes_are_a_fraction(holes):
    with pytest.raises(ValueError, match=r"is not a fraction in 0\.\.1"):
        lattice(3, 3, holes)


@pytest.mark.parametrize(
    ("build", "named"),
    [
        (lambda: lattice(0, 3), "rows = 0"),
        (lambda: lattice(3, -1), "columns = -1"),
        (lambda: lattice(1, 1), r"rows \* columns = 1"),
        (lambda: dense(1), "vertices = 1"),
        (lambda: cycle(0), "n = 0"),
    ],
)
def test_a_size_without_an_edge_is_refused(build, named):
    with pytest.raises(ValueError, match=named):
        build()


@pytest.mark.parametrize(
    ("family", "least"),
    [("bouquet", 1), ("cycle", 1), ("dipole", 1), ("path", 2), ("star", 1), ("wheel", 3)],
)
def test_a_named_map_has_a_least_and_a_largest_number(family, least, monkeypatch):
    assert named_map(f"{family}-{least}").edge_count >= 1
    monkeypatch.setitem(build._NUMBERED, family, (least, lambda number: number))
    assert [named_map(f"{family}-{n}") for n in (least, 10_000)] == [least, 10_000]
    for wrong in (least - 1, 10_001, 10_000_000, 10**30):
        told = f"'{family}-{wrong}' is no map: .* an integer N >= {least}, and at most 10000"
        with pytest.raises(ValueError, match=told):
            named_map(f"{family}-{wrong}")


@pytest.mark.parametrize(
    ("made", "edges"),
    [
        (lambda: lattice(1, 2), 1),
        (lambda: lattice(2, 1), 1),
        (lambda: dense(2), 1),
        (lambda: cycle(1), 1),
        (lambda: lattice(3, 3, 0), 12),
    ],
)
def test_the_smallest_map_of_a_kind_has_an_edge(made, edges):
    assert made().edge_count == edges


def test_all_edges_but_those_of_a_tree_may_be_holes():
    assert cycle(3).edge_count == 3
    with pytest.raises(ValueError, match=r"holes = 1 would remove 1 of 1 edges, but at most 0 can"):
        lattice(1, 2, 1)
