"""The checkers' enumeration lists what the package's does, code by code."""

import pytest

from proofs import test_maps as quick


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("map_class", "edges", "most", "count"),
    [("maps", 5, None, 8162), ("planar-simple", 8, 6, None)],
)
def test_two_enumerations_list_the_same_rooted_maps(checkers, map_class, edges, most, count):
    quick.test_two_enumerations_list_the_same_rooted_maps(checkers, map_class, edges, most, count)
