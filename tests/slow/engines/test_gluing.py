import pytest

from allworlds.engines.units import LevelUnit
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.studies.count import Counted, count_compiled, count_one_by_one

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.parametrize("vertices", [None, 2, 4])
@pytest.mark.parametrize("edges", [1, 2, 3, 4, 5])
def test_the_compiled_count_is_the_count_one_by_one(edges, vertices):
    bounds = Extent(MapClass.MAPS, edges, vertices)
    unit, slow = LevelUnit(edges, ()), Counted()
    for part in count_one_by_one(bounds, unit):
        slow.add(part)
    assert count_compiled(bounds, unit).cells == slow.cells
