"""Counts of the maps that a partial gluing can become, compared with the enumeration."""

import pytest

from allworlds.engines.units import Shard, level_size, units_of_level
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent


@pytest.mark.parametrize("map_class", [MapClass.SIMPLE, MapClass.PLANAR_SIMPLE])
def test_eight_shards_of_a_simple_class_are_balanced(map_class):
    """Each within a tenth of the mean, though the weights are upper bounds: maps are counted."""
    extent = Extent(map_class, 7)
    worlds = worlds_of_shards(extent, 7, 8)
    assert sum(worlds) == level_size(extent, 7)
    assert max(worlds) <= 1.1 * sum(worlds) / 8
    assert min(worlds) >= 0.9 * sum(worlds) / 8


def worlds_of_shards(extent, edges, count):
    """How many maps each shard holds, by meeting all."""
    return [
        sum(1 for unit in units_of_level(extent, edges, Shard(k, count)) for _ in unit.maps(extent))
        for k in range(count)
    ]


def test_no_unit_falls_to_two_shards():
    extent = Extent(MapClass.SIMPLE, None, 4)
    for edges in extent.levels:
        every = [unit.key for unit in units_of_level(extent, edges)]
        for count in (1, 3, 1000):
            shards = [
                unit.key
                for k in range(count)
                for unit in units_of_level(extent, edges, Shard(k, count))
            ]
            assert sorted(shards) == sorted(every)
