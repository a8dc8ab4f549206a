import pytest
from test_bruteforce import walked

from bruteforce import rooted_maps_by_permutations as rooted_maps, unrooted_maps


@pytest.mark.parametrize("edges", [1, 2, 3, 4])
def test_an_unrooted_map_is_its_own_least_rooting(edges):
    rooted = rooted_maps(edges)
    for a in unrooted_maps(edges):
        rootings = [b for b in rooted if any(walked(a, d, b, 0) for d in a.darts)]
        assert a == min(rootings, key=lambda b: (b.sigma, b.alpha))
