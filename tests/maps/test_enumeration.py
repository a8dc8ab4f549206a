from collections import Counter
from itertools import islice

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
from allworlds.maps.classes import Extent, condition_named
from allworlds.maps.count_source import listed
from allworlds.maps.enumeration import FINGERPRINTS, Gluing, fingerprint, prefixes

LEVELS = [(map_class, edges) for map_class in MapClass for edges in (1, 2, 3, 4)]


def codes(maps):
    return [rooted_code(map_.sigma, map_.alpha, 0) for map_ in maps]


@pytest.mark.parametrize(("map_class", "edges"), LEVELS)
def test_gluing_meets_each_map_that_trying_all_permutations_meets_once(map_class, edges):
    met = codes(rooted_maps(edges, map_class))
    assert len(met) == len(set(met))
    tried = bruteforce.rooted_maps_by_permutations(edges, map_class.value)
    assert set(met) == {(map_.sigma, map_.alpha) for map_ in tried}


@pytest.mark.parametrize("map_class", MapClass)
def test_the_order_is_fixed(map_class):
    assert list(rooted_maps(4, map_class)) == list(rooted_maps(4, map_class))


def test_the_class_is_that_of_all_maps_unless_another_is_named():
    assert list(rooted_maps(3)) == list(rooted_maps(3, MapClass.MAPS))


@pytest.mark.parametrize("map_class", [MapClass.MAPS, MapClass.PLANAR])
def test_the_first_maps_of_a_level_too_large_to_finish_come_at_once(map_class):
    for map_ in islice(rooted_maps(60, map_class), 3):
        assert map_class.includes(CombinatorialMap(map_.sigma, map_.alpha))


@pytest.mark.parametrize(("map_class", "edges"), LEVELS)
def test_a_bound_on_the_vertices_only_leaves_maps_out(map_class, edges):
    everything = list(rooted_maps(edges, map_class))
    for vertices in range(1, edges + 3):
        few = [map_ for map_ in everything if map_.vertex_count <= vertices]
        assert list(rooted_maps(edges, map_class, vertices)) == few


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


@pytest.mark.parametrize(("map_class", "edges"), LEVELS)
def test_the_rootings_of_all_unrooted_maps_are_all_rooted_maps(map_class, edges):
    unrooted = {unrooted_code(map_) for map_ in rooted_maps(edges, map_class)}
    weights = [2 * edges // automorphisms(CombinatorialMap(*code)) for code in unrooted]
    assert sum(weights) == sum(1 for _ in rooted_maps(edges, map_class))


def relabelled(map_, order):
    """The map with other numbers for its darts, but for dart 0."""
    back = {d: i for i, d in enumerate(order)}
    sigma, alpha = ([back[row[d]] for d in order] for row in (map_.sigma, map_.alpha))
    return CombinatorialMap(sigma, alpha)


def test_a_fingerprint_is_that_of_a_rooted_map_in_any_numbering():
    maps = [map_ for m in (1, 2, 3, 4) for map_ in rooted_maps(m)]
    prints = [fingerprint(map_) for map_ in maps]
    assert len({*prints}) == len(maps)
    assert prints == [fingerprint(relabelled(map_, [0, *map_.darts[:0:-1]])) for map_ in maps]
    assert min(prints) > 0
    assert max(prints) < FINGERPRINTS


@pytest.mark.parametrize("condition", [None, "trees", "cubic", "girth=3", "triangulation"])
@pytest.mark.parametrize("map_class", MapClass)
def test_each_class_has_the_worlds_that_all_maps_list(map_class, condition):
    where = condition and condition_named(condition)
    for edges in (2, 3, 4):
        sums = Counter()
        for map_ in rooted_maps(edges, map_class, where=where):
            sums[map_.vertex_count] += fingerprint(map_)
        found = {n: each % FINGERPRINTS for n, each in sums.items()}
        assert found == listed(Extent(map_class, edges, where=where), edges)


@pytest.mark.parametrize("vertices", [2, 3, 4, 5])
@pytest.mark.parametrize("edges", [2, 4, 5])
def test_no_piece_of_a_simple_class_begins_with_more_darts_than_there_are_neighbours(
    edges, vertices
):
    begun = {-degree for (degree,) in prefixes(edges, MapClass.SIMPLE, vertices, depth=1)}
    assert begun == {*range(1, min(edges, vertices - 1) + 1)}
