"""Sources of the numbers of maps under a condition, compared with enumeration and literature."""

import pytest
from test_narrowed import NAMES, source_under

from allworlds.maps import MapClass, rooted_maps
from allworlds.maps.classes import condition_named
from allworlds.maps.counting import vertex_counts


@pytest.mark.parametrize(
    ("name", "map_class", "edges"),
    [
        *(("cubic", map_class, 9) for map_class in MapClass),
        *(("triangulation", map_class, 9) for map_class in MapClass),
        *(("regular:4", map_class, 8) for map_class in MapClass),
        *(("quadrangulation", map_class, 8) for map_class in MapClass),
        *(("trees", map_class, 8) for map_class in MapClass),
    ],
)
def test_narrow_classes_are_counted_far_beyond_the_others(name, map_class, edges):
    met = sum(1 for _ in rooted_maps(edges, map_class, where=condition_named(name)))
    if source := source_under(map_class, name):
        assert sum(source.cells(edges).values()) == met
    assert (met > 0) == ((name, "simple" in map_class) != ("regular:4", True))


@pytest.mark.parametrize("map_class", list(MapClass))
@pytest.mark.parametrize("name", NAMES)
def test_each_source_counts_what_is_enumerated(name, map_class):
    for edges in (1, 2, 3, 4, 5):
        cells = dict.fromkeys(vertex_counts(edges), 0)
        for map_ in rooted_maps(edges, map_class, where=condition_named(name)):
            cells[map_.vertex_count] += 1
        if source := source_under(map_class, name):
            assert source.cells(edges) == cells
