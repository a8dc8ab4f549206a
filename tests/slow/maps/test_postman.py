"""The shortest walk along every edge, against a search through all walks."""

import pytest
import test_postman as quick
from test_postman import searched

from allworlds.maps import covering_walk, family


@pytest.mark.parametrize("edges", [4])
def test_no_walk_along_every_edge_is_shorter_and_one_is_so_long(edges):
    quick.test_no_walk_along_every_edge_is_shorter_and_one_is_so_long(edges)


@pytest.mark.parametrize("text", ["lattice:3x3", "cubic:6", "thick:4x3", "random:9"])
def test_it_is_so_in_larger_worlds_whatever_the_start(text):
    map_ = family(text, seed=2)
    found = [covering_walk(map_, dart) for dart in map_.darts]
    assert found == [searched(map_, dart) for dart in map_.darts]
