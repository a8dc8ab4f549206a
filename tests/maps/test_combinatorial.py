import json
from dataclasses import FrozenInstanceError
from itertools import product

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, strategies as st

from allworlds.inputs.checks import InputError, integer
from allworlds.maps import CombinatorialMap, InvalidMap
from allworlds.maps.combinatorial import cycles
from small import EDGE, LOOP, joined, labelled_pairs, maps

HUGE = 10**5000  # more digits than Python turns into text by default


class Contrary(int):
    """An integer whose operators are not to be trusted."""

    def __eq__(self, other):
        return False

    def __hash__(self):
        return 0

    def __lt__(self, other):
        return True

    def __index__(self):
        return int.__index__(self)


class Indexed:
    def __index__(self):
        return 1


def multigraph(map_):
    graph = nx.MultiGraph()
    graph.add_nodes_from(range(map_.vertex_count))
    graph.add_edges_from((map_.vertex_of[d], map_.vertex_of[e]) for d, e in map_.edges)
    return graph


# ---------------------------------------------------------------- the one law


@pytest.mark.parametrize(
    ("sigma", "alpha", "named"),
    [
        ([0, 1], [1, 0, 2], ["sigma has 2", "alpha 3"]),
        ([0, 1, 2, 3], [1, 0], ["sigma has 4", "alpha 2"]),
        ([], [], ["not 0", "m >= 1"]),
        ([0], [0], ["not 1", "2m"]),
        ([0, 1, 2], [1, 0, 2], ["not 3", "2m"]),
        ([0, 2], [1, 0], ["sigma[1] = 2", "0..1"]),
        ([-1, 1], [1, 0], ["sigma[0] = -1", "0..1"]),
        ([0, 1], [1, 5], ["alpha[1] = 5", "0..1"]),
        ([0, 1], [-2, 0], ["alpha[0] = -2", "0..1"]),
        ([1, 1], [1, 0], ["sigma[0] = sigma[1] = 1", "permutation"]),
        ([0, 1, 3, 3], [1, 0, 3, 2], ["sigma[2] = sigma[3] = 3", "permutation"]),
        ([0, 1], [0, 0], ["alpha[0] = alpha[1] = 0", "permutation"]),
        ([1, 0], [0, 1], ["alpha[0] = 0", "fixed point"]),
        ([1, 2, 3, 0], [1, 0, 2, 3], ["alpha[2] = 2", "fixed point"]),
        ([0, 1, 2, 3], [1, 2, 3, 0], ["alpha[0] = 1", "alpha[1] = 2", "involution"]),
        ([0, 1, 2, 3], [1, 0, 3, 2], ["dart 2", "connected"]),
        ([1, 0, 3, 2], [1, 0, 3, 2], ["dart 2", "connected"]),
        ([2, 1, 0, 3], [2, 3, 0, 1], ["dart 1", "connected"]),
    ],
)
def test_what_is_no_map_is_refused_and_the_message_names_the_entry(sigma, alpha, named):
    with pytest.raises(InvalidMap) as refusal:
        CombinatorialMap(sigma, alpha)
    for words in named:
        assert words in str(refusal.value)


@pytest.mark.parametrize(
    "value",
    [True, False, 1.0, 0.5, "1", None, b"1", [1], (), 1j, np.float64(1), np.True_, object],
)
@pytest.mark.parametrize("name", ["sigma", "alpha"])
def test_what_is_no_integer_is_refused_by_name_and_place(name, value):
    good, bad = [0, 1], [0 if name == "sigma" else 1, value]
    with pytest.raises(InvalidMap) as refusal:
        CombinatorialMap(*([bad, [1, 0]] if name == "sigma" else [good, bad]))
    assert f"{name}[1] = {value!r} is not an integer" in str(refusal.value)


@pytest.mark.parametrize("values", ["01", b"01", bytearray, {0: 0, 1: 1}, 7, None, 1.5])
@pytest.mark.parametrize("name", ["sigma", "alpha"])
def test_what_is_no_sequence_is_refused_by_name(name, values):
    with pytest.raises(InvalidMap) as refusal:
        CombinatorialMap(**{"sigma": [0, 1], "alpha": [1, 0], name: values})
    assert f"{name} must be a sequence of darts, not {values!r}" in str(refusal.value)


@pytest.mark.parametrize("number", [HUGE, -HUGE], ids=["positive", "negative"])
def test_an_entry_with_thousands_of_digits_is_refused_like_any_other(number):
    with pytest.raises(InvalidMap, match=r"sigma\[1\]"):
        CombinatorialMap([0, number], [1, 0])


def test_a_refused_map_is_a_wrong_input_and_a_wrong_value():
    assert issubclass(InvalidMap, InputError)
    assert issubclass(InvalidMap, ValueError)


@pytest.mark.parametrize(
    "kind",
    [list, tuple, iter, np.array, lambda d: (x for x in d), lambda d: [np.int8(x) for x in d]],
)
def test_every_iterable_of_integers_is_welcome(kind):
    assert CombinatorialMap(kind([1, 0]), kind([1, 0])) == LOOP


@pytest.mark.parametrize(
    "one", [1, np.int64(1), np.uint8(1), Contrary(1), Indexed()], ids=lambda one: type(one).__name__
)
def test_whatever_stands_for_an_integer_becomes_a_plain_one(one):
    map_ = CombinatorialMap([one, 0], [one, 0])
    assert map_ == LOOP
    assert {type(d) for d in map_.sigma + map_.alpha} == {int}
    assert type(integer(one)) is int
    assert integer(one) == 1


@pytest.mark.parametrize("value", [True, 1.0, "1", None, []])
def test_the_integer_of_what_is_none_is_a_type_error(value):
    with pytest.raises(TypeError):
        integer(value)


@given(labelled_pairs())
def test_a_pair_of_permutations_is_a_map_exactly_if_it_is_connected(pair):
    graph = joined(*pair)
    if nx.is_connected(graph):
        map_ = CombinatorialMap(*pair)
        assert (list(map_.sigma), list(map_.alpha)) == tuple(pair)
    else:
        lost = min(set(graph) - nx.node_connected_component(graph, 0))
        with pytest.raises(InvalidMap, match=f"dart {lost} cannot be reached"):
            CombinatorialMap(*pair)


def test_of_all_pairs_of_sequences_of_two_darts_two_are_maps():
    accepted = []
    for sigma, alpha in product(product(range(2), repeat=2), repeat=2):
        try:
            accepted.append(CombinatorialMap(sigma, alpha))
        except InvalidMap:
            continue
    assert accepted == [EDGE, LOOP]


def test_a_map_cannot_be_changed():
    for name in ("sigma", "alpha"):
        with pytest.raises(FrozenInstanceError):
            setattr(EDGE, name, (1, 0))


def test_equality_and_hash_are_those_of_the_permutations():
    assert CombinatorialMap([0, 1], [1, 0]) == EDGE
    assert hash(CombinatorialMap([0, 1], [1, 0])) == hash(EDGE)
    assert EDGE != LOOP
    assert CombinatorialMap.trusted([0, 1], [1, 0]) == EDGE
    assert EDGE != ((0, 1), (1, 0))


# ---------------------------------------------------------------- what is derived


@pytest.mark.parametrize(
    ("sigma", "alpha", "degrees", "faces", "genus", "loops", "parallels"),
    [
        # one edge; a loop
        ((0, 1), (1, 0), (1, 1), ((0, 1),), 0, 0, 0),
        ((1, 0), (1, 0), (2,), ((0,), (1,)), 0, 1, 0),
        # two loops in the plane and on the torus
        ((1, 2, 3, 0), (1, 0, 3, 2), (4,), ((0, 2), (1,), (3,)), 0, 2, 0),
        ((1, 2, 3, 0), (2, 3, 0, 1), (4,), ((0, 3, 2, 1),), 1, 2, 0),
        # three parallel edges in the plane and on the torus
        ((1, 2, 0, 4, 5, 3), (3, 5, 4, 0, 2, 1), (3, 3), ((0, 4), (1, 3), (2, 5)), 0, 0, 2),
        ((1, 2, 0, 4, 5, 3), (3, 4, 5, 0, 1, 2), (3, 3), ((0, 4, 2, 3, 1, 5),), 1, 0, 2),
        # two parallel edges, one of them with a tail
        ((1, 0, 3, 4, 2, 5), (2, 3, 0, 1, 5, 4), (2, 3, 1), None, 0, 0, 1),
        # the triangle
        ((1, 0, 3, 2, 5, 4), (2, 5, 0, 4, 3, 1), (2, 2, 2), ((0, 3, 5), (1, 4, 2)), 0, 0, 0),
    ],
)
def test_small_maps_have_the_properties_that_one_sees(
    sigma, alpha, degrees, faces, genus, loops, parallels
):
    map_ = CombinatorialMap(sigma, alpha)
    assert map_.degrees == degrees
    assert faces is None or map_.faces == faces
    assert map_.genus == genus
    assert map_.is_planar == (genus == 0)
    assert (map_.loop_count, map_.parallel_count) == (loops, parallels)
    assert map_.is_simple == (loops == parallels == 0)


@given(maps())
def test_vertices_edges_and_faces_are_the_orbits_of_sigma_alpha_and_phi(map_):
    phi = [map_.sigma[map_.alpha[d]] for d in map_.darts]
    for found, permutation in (
        (map_.vertices, map_.sigma),
        (map_.edges, map_.alpha),
        (map_.faces, phi),
    ):
        orbits = nx.connected_components(nx.Graph(list(enumerate(permutation))))
        assert {frozenset(cycle) for cycle in found} == {frozenset(orbit) for orbit in orbits}
        assert list(found) == sorted(found)
        for cycle in found:
            assert cycle[0] == min(cycle)
            assert all(
                permutation[a] == b for a, b in zip(cycle, (*cycle[1:], cycle[0]), strict=True)
            )
    assert list(map_.darts) == list(range(2 * map_.edge_count))
    assert (map_.vertex_count, map_.edge_count) == (len(map_.vertices), len(map_.edges))


@given(maps())
def test_eulers_formula_gives_a_genus_that_is_a_natural_number(map_):
    assert map_.vertex_count - map_.edge_count + len(map_.faces) == 2 - 2 * map_.genus
    assert map_.genus >= 0
    assert map_.is_planar == (map_.genus == 0)


@given(maps())
def test_loops_and_parallel_edges_are_those_of_the_graph(map_):
    graph = multigraph(map_)
    simple = nx.Graph(graph)
    loops = nx.number_of_selfloops(graph)
    simple.remove_edges_from(list(nx.selfloop_edges(simple)))
    assert map_.loop_count == loops
    assert map_.parallel_count == map_.edge_count - loops - simple.number_of_edges()
    assert map_.is_simple == (map_.edge_count == simple.number_of_edges())
    assert map_.degrees == tuple(degree for _, degree in sorted(graph.degree()))


@given(maps())
def test_every_dart_knows_its_vertex_and_degree(map_):
    for d in map_.darts:
        assert d in map_.vertices[map_.vertex_of[d]]
        assert map_.degree_at[d] == len(map_.vertices[map_.vertex_of[d]])


@given(maps(), st.data(), st.integers(-30, 30))
def test_turning_is_sigma_so_many_times_and_offset_undoes_it(map_, data, k):
    d = e = data.draw(st.sampled_from(map_.darts))
    for _ in range(k):
        e = map_.sigma[e]
    for _ in range(-k):
        e = map_.sigma.index(e)
    assert map_.turn(d, k) == e
    assert map_.offset(d, e) == k % map_.degree_at[d]


def test_there_is_no_offset_between_two_vertices():
    with pytest.raises(ValueError, match="darts 0 and 1 are not at one vertex"):
        EDGE.offset(0, 1)


# ---------------------------------------------------------------- maps from maps


@given(maps(), st.data())
def test_relabelling_renames_every_dart_and_changes_nothing_else(map_, data):
    names = data.draw(st.permutations(map_.darts))
    renamed = map_.relabelled(names)
    for d in map_.darts:
        assert renamed.sigma[names[d]] == names[map_.sigma[d]]
        assert renamed.alpha[names[d]] == names[map_.alpha[d]]
    back = [names.index(d) for d in map_.darts]
    assert renamed.relabelled(back) == map_
    assert CombinatorialMap(renamed.sigma, renamed.alpha) == renamed


@pytest.mark.parametrize("names", [[0], [0, 0], [1, 2], [0, 1, 2], []])
def test_names_that_are_no_permutation_of_the_maps_darts_are_refused(names):
    with pytest.raises(ValueError, match=r"no permutation of the darts 0\.\.1") as refusal:
        EDGE.relabelled(names)
    assert str(names) in str(refusal.value)


@given(maps())
def test_the_mirror_turns_the_other_way_and_mirrors_back(map_):
    mirrored = map_.mirrored()
    assert CombinatorialMap(mirrored.sigma, mirrored.alpha) == mirrored
    assert all(mirrored.sigma[map_.sigma[d]] == d for d in map_.darts)
    assert mirrored.alpha == map_.alpha
    assert mirrored.mirrored() == map_
    assert mirrored.genus == map_.genus


@given(maps())
def test_the_dual_swaps_vertices_and_faces_and_the_dual_of_the_dual_is_the_map(map_):
    dual = map_.dual()
    assert CombinatorialMap(dual.sigma, dual.alpha) == dual
    assert dual.vertices == map_.faces
    assert dual.faces == map_.vertices
    assert dual.genus == map_.genus
    assert dual.dual() == map_


# ---------------------------------------------------------------- JSON


@given(maps())
def test_a_map_survives_json_as_object_and_as_text(map_):
    document = map_.to_json()
    assert document == {"sigma": list(map_.sigma), "alpha": list(map_.alpha)}
    assert CombinatorialMap.from_json(document) == map_
    assert CombinatorialMap.from_json(json.dumps(document)) == map_
    tuples = {"sigma": map_.sigma, "alpha": map_.alpha, "start": 0}
    assert CombinatorialMap.from_json(tuples) == map_


@pytest.mark.parametrize(
    ("document", "named"),
    [
        ("", "not JSON"),
        ("{", "not JSON"),
        ("[0, 1]", "not [0, 1]"),
        ("7", "not 7"),
        ("null", "not None"),
        ([[0, 1], [1, 0]], "not [[0, 1], [1, 0]]"),
        ({}, "'sigma' is missing; a map has 'sigma' and 'alpha'"),
        ({"sigma": [0, 1]}, "'alpha' is missing"),
        ({"sigma": "01", "alpha": [1, 0]}, "'sigma' must be a list of darts, not '01'"),
        ({"sigma": [0, 1], "alpha": {"0": 1}}, "'alpha' must be a list of darts, not {'0': 1}"),
        ({"sigma": [0, 1], "alpha": [1, 1.0]}, "alpha[1] = 1.0 is not an integer"),
        ('{"sigma": [0, true], "alpha": [1, 0]}', "sigma[1] = True is not an integer"),
        ('{"sigma": [0, 1], "alpha": [0, 1]}', "alpha[0] = 0"),
    ],
)
def test_a_document_that_is_no_map_is_refused_by_name(document, named):
    with pytest.raises(InvalidMap) as refusal:
        CombinatorialMap.from_json(document)
    assert named in str(refusal.value)


def test_text_with_an_integer_of_thousands_of_digits_is_refused_as_no_map():
    text = f'{{"sigma": [0, {"1" * 5000}], "alpha": [1, 0]}}'
    with pytest.raises(InvalidMap):
        CombinatorialMap.from_json(text)


def test_text_nested_thousands_deep_is_refused_as_no_map():
    with pytest.raises(InvalidMap):
        CombinatorialMap.from_json("[" * 100_000)


@pytest.mark.parametrize(
    ("sigma", "alpha", "tried"),
    [
        ([1, 0, 3, 3], [1, 0, 3, 2], "sigma [1, 0, 3, 3]\nalpha [1, 0, 3, 2]"),
        ([0, 9], [None, 0], "sigma [0, 9]\nalpha [None, 0]"),
        ([0, 1], [1], "sigma [0, 1]\nalpha [1]"),
        ([], [], ""),
        (7, [1, 0], ""),
    ],
)
def test_what_was_tried_is_kept(sigma, alpha, tried):
    with pytest.raises(InvalidMap) as refusal:
        CombinatorialMap(sigma, alpha)
    assert refusal.value.tried == tried


def test_of_many_darts_the_first_are_shown():
    with pytest.raises(InvalidMap) as refusal:
        CombinatorialMap([*range(1000)], [10**30] * 1000)
    assert max(map(len, refusal.value.tried.splitlines())) < 300


# ---------------------------------------------------------------- cycles


@given(st.integers(0, 9).flatmap(lambda n: st.permutations(range(n))))
def test_the_cycles_of_a_permutation_rebuild_it(permutation):
    found = cycles(permutation)
    rebuilt = {a: cycle[(i + 1) % len(cycle)] for cycle in found for i, a in enumerate(cycle)}
    assert rebuilt == dict(enumerate(permutation))
    assert sum(map(len, found)) == len(permutation)
    assert [cycle[0] for cycle in found] == sorted(min(cycle) for cycle in found)
