from itertools import pairwise

import pytest

from allworlds.maps import rooted_code
from allworlds.studies.ambiguity import twins
from allworlds.world import Directional
from studies import test_telling_apart as quick
from studies.test_telling_apart import twins_module, worlds


@pytest.mark.slowest
def test_directional_worlds_are_told_apart_unless_they_are_the_same():
    # All pairs with at most three edges: a directional marker settles the map and the pose.
    known = {}
    for world in worlds(Directional, 3):
        code = rooted_code(world.map.sigma, world.map.alpha, 0)
        known[code, world.first.bearing] = world
    different = list(known.values())
    assert len(different) == 309  # 2, 10, 74 rooted maps weighed by the degree of the root
    for i, one in enumerate(different):
        for other in different[:i]:
            assert not same_start_class(one, other)
    for one, other in pairwise(different):
        assert twins(one, other).distinguishable


def same_start_class(one, other):
    labelled = [(w.map, w.percepts, w.start) for w in (one, other)]
    first, second = twins_module.classes_of_union(*labelled)
    return first[one.start] == second[other.start]


@pytest.mark.slowest
@pytest.mark.parametrize(("kind", "fewest"), [("natural", 4)])
def test_worlds_look_alike_under_a_cluster_from_3_edges_on_and_under_a_natural_from_4(kind, fewest):
    quick.test_worlds_look_alike_under_a_cluster_from_3_edges_on_and_under_a_natural_from_4(
        kind, fewest
    )
