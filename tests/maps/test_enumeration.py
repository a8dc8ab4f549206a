from collections import Counter
from itertools import chain, islice
from math import factorial

import pytest

import bruteforce
from allworlds.maps import (
    CombinatorialMap,
    MapClass,
    automorphisms,
    rooted_code,
    rooted_maps,
    unrooted_code,
)
from allworlds.maps.classes import Extent
from allworlds.maps.counting import SOURCES
from allworlds.maps.enumeration import Gluing, prefixes

LEVELS = [(map_class, edges) for map_class in MapClass for edges in (1, 2, 3, 4)]
GATED = [(c, m) for c in MapClass for m in range(1, 7 if c.simple else 6)]
FURTHER = [(c, 7 if c.simple else 6) for c in MapClass]


def codes(maps):
    return [rooted_code(map_.sigma, map_.alpha, 0) for map_ in maps]


@pytest.mark.no_cover
@pytest.mark.parametrize(("map_class", "edges"), LEVELS)
def test_gluing_meets_each_map_that_trying_all_permutations_meets_once(map_class, edges):
    met = codes(rooted_maps(edges, map_class))
    assert len(met) == len(set(met))
    tried = bruteforce.rooted_maps_by_permutations(edges, map_class.value)
    assert set(met) == {(map_.sigma, map_.alpha) for map_ in tried}


@pytest.mark.slow
@pytest.mark.no_cover
@pytest.mark.parametrize(("map_class", "edges"), [*GATED, *FURTHER])
def test_every_cell_holds_as_many_maps_as_the_independent_source_says(map_class, edges):
    cells = SOURCES[map_class.value].cells(edges)
    met = Counter(map_.vertex_count for map_ in rooted_maps(edges, map_class))
    assert met == {n: count for n, count in cells.items() if count}


@pytest.mark.slow
@pytest.mark.no_cover
@pytest.mark.parametrize(("map_class", "edges"), [(c, m) for c in MapClass for m in (3, 5)])
def test_every_map_is_in_its_class_and_lawful_and_met_once(map_class, edges):
    met = list(rooted_maps(edges, map_class))
    for map_ in met:
        assert CombinatorialMap(map_.sigma, map_.alpha) == map_
        assert map_class.includes(map_)
        assert map_.edge_count == edges
        # The darts of a vertex are consecutive, in the order of sigma.
        assert list(chain(*map_.vertices)) == list(map_.darts)
    assert len(set(codes(met))) == len(met)


@pytest.mark.parametrize("map_class", MapClass)
def test_the_order_is_fixed(map_class):
    assert list(rooted_maps(4, map_class)) == list(rooted_maps(4, map_class))


def test_the_class_is_that_of_all_maps_unless_another_is_named():
    assert list(rooted_maps(3)) == list(rooted_maps(3, MapClass.MAPS))


@pytest.mark.parametrize("map_class", [MapClass.MAPS, MapClass.PLANAR])
def test_the_first_maps_of_a_level_too_large_to_finish_come_at_once(map_class):
    for map_ in islice(rooted_maps(60, map_class), 3):
        assert map_class.includes(CombinatorialMap(map_.sigma, map_.alpha))


@pytest.mark.no_cover
@pytest.mark.parametrize(("map_class", "edges"), LEVELS)
def test_a_bound_on_the_vertices_only_leaves_maps_out(map_class, edges):
    everything = list(rooted_maps(edges, map_class))
    for vertices in range(1, edges + 3):
        few = [map_ for map_ in everything if map_.vertex_count <= vertices]
        assert list(rooted_maps(edges, map_class, vertices)) == few


@pytest.mark.slow
@pytest.mark.no_cover
@pytest.mark.parametrize("vertices", [None, 2, 3])
@pytest.mark.parametrize(("map_class", "edges"), LEVELS)
def test_the_prefixes_of_every_depth_partition_the_level_in_its_order(map_class, edges, vertices):
    level = list(rooted_maps(edges, map_class, vertices))
    for depth in range(2 * edges + 2):
        histories = list(prefixes(edges, map_class, vertices, depth))
        assert len(histories) == len(set(histories))
        parts = [list(rooted_maps(edges, map_class, vertices, h)) for h in histories]
        assert list(chain(*parts)) == level


@pytest.mark.slow
@pytest.mark.parametrize("vertices", [None, 2, 3])
@pytest.mark.parametrize("edges", [1, 2, 3, 4])
@pytest.mark.parametrize("map_class", [MapClass.MAPS, MapClass.PLANAR])
def test_no_history_is_begun_that_cannot_be_finished(map_class, edges, vertices):
    begun = chain(*(prefixes(edges, map_class, vertices, depth) for depth in range(edges + 2)))
    dead = [h for h in begun if not any(rooted_maps(edges, map_class, vertices, h))]
    assert dead == []


def test_without_a_depth_prefixes_have_two_decisions():
    assert list(prefixes(4)) == list(prefixes(4, MapClass.MAPS, None, 2))
    assert {len(history) for history in prefixes(4)} == {2}


def test_histories_cut_at_their_end_are_the_maps():
    # One decision for the root's degree and one for each edge.
    assert {len(history) for history in prefixes(4, depth=99)} == {5}
    assert len(list(prefixes(4, depth=99))) == 706  # OEIS A000698


def test_the_decisions_of_the_triangle_are_its_degrees_and_one_gluing():
    # Darts 0, 1 at the root; 0 leads to a new vertex (2, 3), 1 to another (4, 5); 3 meets 5.
    (triangle,) = rooted_maps(3, MapClass.SIMPLE, prefix=(-2, -2, -2, 5))
    assert triangle.sigma == (1, 0, 3, 2, 5, 4)
    assert triangle.alpha == (2, 4, 0, 5, 1, 3)


def test_the_successors_come_in_the_fixed_order_gluings_first_then_degrees():
    gluing = Gluing(3, MapClass.MAPS)
    assert [decision for decision, _ in gluing.successors()] == [-1, -2, -3, -4, -5, -6]
    gluing.apply(-4)
    assert gluing.owed == 2
    assert not gluing.finished
    assert [decision for decision, _ in gluing.successors()] == [1, 2, 3, -1, -2]


def test_taking_a_successor_leaves_the_gluing_as_it_was():
    gluing = Gluing(3, MapClass.PLANAR)
    gluing.apply(-3)
    before = [[*gluing.alpha], [*gluing.degrees], [list(face) for face in gluing.faces]]
    after = dict(gluing.successors())
    assert [gluing.alpha, gluing.degrees, gluing.faces] == before
    for decision, successor in after.items():
        for _, last in successor.successors():
            assert last.degrees[:1] == [3]
        assert successor.alpha[0] == (decision if decision > 0 else 3)


@pytest.mark.no_cover
@pytest.mark.parametrize(("map_class", "edges"), LEVELS)
def test_the_rootings_of_all_unrooted_maps_are_all_rooted_maps(map_class, edges):
    unrooted = {unrooted_code(map_) for map_ in rooted_maps(edges, map_class)}
    weights = [2 * edges // automorphisms(CombinatorialMap(*code)) for code in unrooted]
    assert sum(weights) == sum(1 for _ in rooted_maps(edges, map_class))


def simple_on(vertices):
    """Every rooted simple map with so many vertices."""
    bounds = Extent(MapClass.SIMPLE, None, vertices)
    for edges in bounds.levels:
        for map_ in rooted_maps(edges, MapClass.SIMPLE, bounds.vertex_limit(edges)):
            if map_.vertex_count == vertices:
                yield map_


# Connected simple graphs with 2, 3, 4, 5 vertices: rooted maps; rotation systems of labelled
# graphs, that is the sum over graphs of the product of (degree - 1)!; and rooted maps with a
# bearing at the root's vertex.  Each from an independent program.
@pytest.mark.slow
@pytest.mark.no_cover
@pytest.mark.parametrize(
    ("vertices", "rooted", "labelled", "with_bearing"),
    [(2, 1, 1, 1), (3, 3, 4, 5), (4, 32, 87, 79), (5, 3965, 27868, 14239)],
)
def test_simple_maps_by_vertices_are_the_labelled_rotation_systems(
    vertices, rooted, labelled, with_bearing
):
    met = list(simple_on(vertices))
    assert len(met) == rooted
    assert sum(map_.degree_at[0] for map_ in met) == with_bearing
    unrooted = {unrooted_code(map_) for map_ in met}
    names = factorial(vertices)
    namings = [names // automorphisms(CombinatorialMap(*code)) for code in unrooted]
    assert sum(namings) == labelled
