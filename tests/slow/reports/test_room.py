"""Room in the pictures, measured in the SVG: angles of crossings, and how near edges come.

Each number that is held is the least that was found, a little below it.
"""

import pytest

from reports import test_room as quick
from reports.test_room import SMALL_APART, held
from small import unrooted_maps


@pytest.mark.slowest
def test_edges_of_small_maps_cross_at_a_good_angle_and_else_keep_apart():
    maps = unrooted_maps(3)
    assert len(maps) == 2 + 5 + 20
    assert sum(held(map_, SMALL_APART) for map_ in maps) >= sum(map_.genus for map_ in maps)


@pytest.mark.slowest
def test_so_do_those_of_every_map_with_four_edges():
    maps = [map_ for map_ in unrooted_maps(4) if map_.edge_count == 4]
    assert len(maps) == 107
    for map_ in maps:
        held(map_, SMALL_APART)


@pytest.mark.slowest
@pytest.mark.parametrize(("edges", "seed"), [*((m, m) for m in (6, 8, 11, 14))])
def test_and_those_of_larger_maps(edges, seed):
    quick.test_and_those_of_larger_maps(edges, seed)
