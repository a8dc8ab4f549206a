from random import Random

import pytest

from allworlds.maps import CombinatorialMap
from allworlds.maps.classes import Extent
from allworlds.maps.mixture import default_mix, generator
from studies import test_sampling as quick
from studies.test_sampling import CLASSES, code, drawn


@CLASSES
def test_a_sample_is_a_function_of_its_seed(map_class):
    assert drawn(map_class, 10, 100, seed=7) == drawn(map_class, 10, 100, seed=7)
    assert drawn(map_class, 10, 100, seed=7) != drawn(map_class, 10, 100, seed=8)


@CLASSES
def test_every_run_has_one_valid_world_of_the_class_within_the_bound(map_class):
    sample = drawn(map_class, 12, 200)
    assert len(sample) == 200
    for map_, places in sample:
        assert CombinatorialMap(map_.sigma, map_.alpha) == map_
        assert map_class.includes(map_)
        assert map_.edge_count <= 12
        ((place, lighthouse),) = places
        assert lighthouse.dart == map_.turn(0, place)


@CLASSES
def test_every_part_makes_what_the_class_can_use(map_class):
    extent = Extent(map_class, 8)
    for part in default_mix(extent):
        random = Random(1)
        found = [generator(part, extent)(8, random) for _ in range(100)]
        assert all(map_.edge_count <= 8 for map_ in found)
        assert len({code(map_) for map_ in found}) > 5
        assert any(map_class.includes(map_) for map_ in found)


@pytest.mark.slowest
@CLASSES
@pytest.mark.parametrize("least", [14])
def test_no_world_of_a_sample_is_smaller_than_it_is_to_be(map_class, least):
    quick.test_no_world_of_a_sample_is_smaller_than_it_is_to_be(map_class, least)
