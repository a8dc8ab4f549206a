"""Sources of the numbers of maps under a condition, compared with enumeration and literature."""

import pytest
from test_narrowed import source_under

from allworlds.maps import MapClass, rooted_maps
from allworlds.maps.classes import condition_named


@pytest.mark.no_cover
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
