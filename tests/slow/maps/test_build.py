"""test_build"""

import pytest

from allworlds.maps.build import lattice


@pytest.mark.timeout(120)  # for a day, if each hole were looked for in all edges
def test_a_large_lattice_with_holes_is_built_quickly():
    assert lattice(60, 60, 0.1).edge_count == 7080 - 708
