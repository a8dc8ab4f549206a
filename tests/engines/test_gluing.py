import pytest

from allworlds.engines.kernel.worlds import by_vertices_and_faces
from allworlds.engines.units import units_of_level
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.counting import rooted_of_genus
from allworlds.maps.enumeration import prefixes
from allworlds.studies import count as counter
from allworlds.studies.count import (
    Counted,
    count_compiled,
    row_of,
)

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.parametrize("depth", [1, 2, 3, 4, 5])
def test_however_the_work_is_cut_the_maps_are_the_same(depth):
    total = {}
    for prefix in prefixes(4, depth=depth):
        for key, maps in by_vertices_and_faces(4, 5, prefix).items():
            total[key] = total.get(key, 0) + maps
    # By duality as many maps have n vertices and f faces as f vertices and n faces.
    assert total == {(f, n): maps for (n, f), maps in total.items()}
    assert sum(total.values()) == 706


def test_a_level_beyond_python_agrees_with_its_sources():
    bounds, total = Extent(MapClass.MAPS, 7), Counted()
    for unit in units_of_level(bounds, 7):
        total.add(count_compiled(bounds, unit))
    row = row_of(bounds, 7, total, whole=True)
    # OEIS A000698; by genus after Carrell and Chapuy.
    assert row.rooted == 1_708_394
    assert dict(row.by_genus) == {g: sum(rooted_of_genus(7, g).values()) for g in range(4)}


def test_counting_passes_to_the_compiled_count(monkeypatch):
    monkeypatch.setattr(counter, "UNROOTED_LIMIT", 3)
    census = counter.count(edges=4)
    assert census.exit_code == 0
    assert [row.unrooted for row in census.rows] == [2, 5, 20, None]
    assert [row.rooted for row in census.rows] == [2, 10, 74, 706]
