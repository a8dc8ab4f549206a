"""Maps and their duals, and the sum of 2m/|Aut|: laws between counts."""

from collections import Counter

import pytest
from hypothesis import find, given, settings

from allworlds.maps import MapClass, automorphisms, rooted_maps, unrooted_code
from allworlds.maps.counting import rooted_maps as counted_maps, rooted_of_genus
from allworlds.strategies import maps, planar_maps
from bruteforce import unrooted_maps

MANY = settings(max_examples=2000)
CLASSES = pytest.mark.parametrize("map_class", list(MapClass))


@given(maps(max_edges=10))
def test_the_dual_exchanges_vertices_and_faces_and_keeps_edges_and_genus(map_):
    dual = map_.dual()
    assert dual.vertices == map_.faces
    assert len(dual.faces) == map_.vertex_count
    assert (dual.edge_count, dual.genus) == (map_.edge_count, map_.genus)
    assert automorphisms(dual) == automorphisms(map_)


@given(maps(max_edges=10))
def test_the_dual_of_the_dual_is_the_map(map_):
    assert map_.dual().dual() == map_


@given(planar_maps(max_edges=10))
def test_the_vertices_of_a_plane_map_and_of_its_dual_are_two_more_than_its_edges(map_):
    assert map_.vertex_count + map_.dual().vertex_count == map_.edge_count + 2


def test_on_other_surfaces_they_are_fewer():
    def fewer(map_):
        return map_.vertex_count + map_.dual().vertex_count < map_.edge_count + 2

    assert find(maps(), fewer, settings=MANY).genus == 1


@pytest.mark.parametrize("map_class", [MapClass.MAPS, MapClass.PLANAR])
@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_as_many_rooted_maps_have_k_faces_as_have_k_vertices(edges, map_class):
    level = list(rooted_maps(edges, map_class))
    assert Counter(m.vertex_count for m in level) == Counter(len(m.faces) for m in level)


@pytest.mark.parametrize("map_class", [MapClass.SIMPLE, MapClass.PLANAR_SIMPLE])
def test_but_the_dual_of_a_simple_map_need_not_be_simple(map_class):
    level = list(rooted_maps(4, map_class))
    assert Counter(m.vertex_count for m in level) != Counter(len(m.faces) for m in level)


@pytest.mark.parametrize("edges", range(1, 13))
def test_plane_counts_are_symmetric_in_vertices_and_faces(edges):
    counted = rooted_of_genus(edges, 0)
    assert counted == {edges + 2 - n: count for n, count in counted.items()}


def test_counts_over_all_genera_are_not():
    counted = counted_maps(4)
    assert counted != {4 + 2 - n: count for n, count in counted.items()}


@CLASSES
@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_every_map_has_2m_over_its_automorphisms_rootings(edges, map_class):
    unrooted = unrooted_maps(edges, map_class)
    rooted = Counter(unrooted_code(m) for m in rooted_maps(edges, map_class))
    assert rooted == {unrooted_code(m): 2 * edges // automorphisms(m) for m in unrooted}
    assert all(2 * edges % automorphisms(m) == 0 for m in unrooted)


def test_the_sum_without_automorphisms_or_with_mirror_images_merged_is_wrong():
    edges = 4  # every smaller map is its own mirror image
    unrooted = unrooted_maps(edges)
    rooted = sum(1 for _ in rooted_maps(edges))
    assert sum(2 * edges for _ in unrooted) > rooted
    merged = {min(unrooted_code(m), unrooted_code(m.mirrored())): m for m in unrooted}
    assert sum(2 * edges // automorphisms(m) for m in merged.values()) < rooted
