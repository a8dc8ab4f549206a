from collections import Counter
from itertools import chain
from math import factorial

import pytest
from test_enumeration import LEVELS, codes

from allworlds.maps import CombinatorialMap, MapClass, automorphisms, rooted_maps, unrooted_code
from allworlds.maps.classes import Extent
from allworlds.maps.counting import SOURCES
from allworlds.maps.enumeration import prefixes

GATED = [(c, m) for c in MapClass for m in range(1, 7 if c.simple else 6)]


FURTHER = [(c, 7 if c.simple else 6) for c in MapClass]


@pytest.mark.slowest
@pytest.mark.parametrize(("map_class", "edges"), [*GATED, *FURTHER])
def test_every_cell_holds_as_many_maps_as_the_independent_source_says(map_class, edges):
    cells = SOURCES[map_class.value].cells(edges)
    met = Counter(map_.vertex_count for map_ in rooted_maps(edges, map_class))
    assert met == {n: count for n, count in cells.items() if count}


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


@pytest.mark.parametrize("vertices", [None, 2, 3])
@pytest.mark.parametrize(("map_class", "edges"), LEVELS)
def test_the_prefixes_of_every_depth_partition_the_level_in_its_order(map_class, edges, vertices):
    level = list(rooted_maps(edges, map_class, vertices))
    for depth in range(2 * edges + 2):
        histories = list(prefixes(edges, map_class, vertices, depth))
        assert len(histories) == len(set(histories))
        parts = [list(rooted_maps(edges, map_class, vertices, h)) for h in histories]
        assert list(chain(*parts)) == level


@pytest.mark.parametrize("vertices", [None, 2, 3])
@pytest.mark.parametrize("edges", [1, 2, 3, 4])
@pytest.mark.parametrize("map_class", [MapClass.MAPS, MapClass.PLANAR])
def test_no_history_is_begun_that_cannot_be_finished(map_class, edges, vertices):
    begun = chain(*(prefixes(edges, map_class, vertices, depth) for depth in range(edges + 2)))
    dead = [h for h in begun if not any(rooted_maps(edges, map_class, vertices, h))]
    assert dead == []


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
