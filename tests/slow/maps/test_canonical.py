import pytest

import bruteforce
from allworlds.maps import unrooted_code

CLASSES = ["maps", "simple", "planar", "planar-simple"]


@pytest.mark.parametrize("map_class", CLASSES)
@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_as_many_unrooted_codes_as_maps(edges, map_class):
    found = {
        unrooted_code(map_) for map_ in bruteforce.rooted_maps_by_permutations(edges, map_class)
    }
    assert found == {(a.sigma, a.alpha) for a in bruteforce.unrooted_maps(edges, map_class)}
