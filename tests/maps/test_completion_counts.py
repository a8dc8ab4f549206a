"""Counts of the maps that a partial gluing can become, compared with the enumeration."""

import pytest

from allworlds.engines.units import LevelUnit, Shard, level_size, units_of_level
from allworlds.maps import MapClass, rooted_maps
from allworlds.maps.classes import Extent
from allworlds.maps.count_source import completions
from allworlds.maps.enumeration import Gluing, prefixes


@pytest.mark.parametrize("depth", [1, 2, 3, 9])
@pytest.mark.parametrize("vertices", [None, 2])
@pytest.mark.parametrize("map_class", list(MapClass))
def test_the_completions_of_a_gluing_are_counted(map_class, vertices, depth):
    for edges in (1, 2, 4):
        for prefix in prefixes(edges, map_class, vertices, depth):
            gluing = Gluing(edges, map_class, vertices)
            for decision in prefix:
                gluing.apply(decision)
            made = sum(1 for _ in rooted_maps(edges, map_class, vertices, prefix))
            if map_class.simple:
                assert completions(gluing) >= made
            else:
                assert completions(gluing) == made


@pytest.mark.parametrize("map_class", [MapClass.MAPS, MapClass.PLANAR])
def test_eight_shards_of_eight_edges_are_balanced(map_class):
    """Within a tenth, each of the other shards too; the weights are the counts."""
    extent = Extent(map_class, 8)
    shards = [units_of_level(extent, 8, Shard(k, 8)) for k in range(8)]
    weights = [sum(unit.weight(extent) for unit in shard) for shard in shards]
    assert sum(weights) == level_size(extent, 8)
    assert max(weights) <= 1.1 * min(weights)


@pytest.mark.parametrize("wrong", [lambda *_: 1, lambda unit, _: len(unit.key)])
def test_shards_by_wrong_weights_are_worse(wrong, monkeypatch):
    extent = Extent(MapClass.PLANAR, 6)
    counted = {unit.key: unit.weight(extent) for unit in units_of_level(extent, 6)}

    def unlike():
        shards = [units_of_level(extent, 6, Shard(k, 4)) for k in range(4)]
        return spread([sum(counted[unit.key] for unit in shard) for shard in shards])

    right = unlike()
    monkeypatch.setattr(LevelUnit, "weight", wrong)
    assert unlike() > 5 * right


def spread(worlds):
    return (max(worlds) - min(worlds)) * len(worlds) / sum(worlds)
