"""Two judges and two enumerators that share no code say the same of whatever is drawn."""

from collections import Counter
from functools import cache

import pytest
from hypothesis import find, given, settings
from hypothesis.strategies import composite, data, integers, permutations, sampled_from

import bruteforce
from allworlds.judging.laws.law_table import Case
from allworlds.judging.walk import Walk
from allworlds.maps import MapClass, moved, rooted_code, rooted_maps
from allworlds.protocol.actions import Estimate
from allworlds.strategies import maps
from allworlds.world import World
from enumerators import BROKEN_ENUMERATORS
from second_opinion import verdict

MANY = settings(max_examples=2000)
SMALL = maps(max_edges=4)


def darts(map_):
    return integers(0, len(map_.sigma) - 1)


@composite
def answers(draw):
    """A true map with a dart, and an answer that may be right, or only just wrong."""
    truth = draw(SMALL)
    how = draw(sampled_from(["same", "mirrored", "moved", "other"]))
    if how == "moved":
        near = list(moved(truth))
        estimate = near[draw(integers(0, len(near) - 1))] if near else truth
    else:
        others = {"same": truth, "mirrored": truth.mirrored()}
        estimate = others[how] if how in others else draw(SMALL)
    estimate = estimate.relabelled(draw(permutations(estimate.darts)))
    return truth, draw(darts(truth)), estimate, draw(darts(estimate))


def judged(truth, dart, estimate, here):
    return Case(Walk.begin(World(truth, "none", dart)), (), Estimate(estimate, here)).answer


@pytest.mark.parametrize("outcome", ["right", "pose", "map"])
def test_every_outcome_is_drawn(outcome):
    assert verdict(*find(answers(), lambda a: judged(*a) == outcome, settings=MANY)) == outcome


@cache
def level(enumerate_, edges, map_class=MapClass.MAPS):
    found = enumerate_(edges, map_class) if map_class is not MapClass.MAPS else enumerate_(edges)
    return Counter(rooted_code(m.sigma, m.alpha, 0) for m in found)


@given(SMALL, data())
def test_both_enumerators_have_every_rooting_of_a_drawn_map_once_or_not_at_all(map_, drawn):
    root = drawn.draw(darts(map_))
    code = rooted_code(map_.sigma, map_.alpha, root)
    for map_class in MapClass:
        expected = int(map_class.includes(map_))
        assert level(rooted_maps, map_.edge_count, map_class)[code] == expected
        assert (
            level(bruteforce.rooted_maps_by_permutations, map_.edge_count, map_class)[code]
            == expected
        )


@pytest.mark.parametrize("broken", BROKEN_ENUMERATORS, ids=lambda broken: broken.name)
def test_a_broken_enumerator_differs_at_some_drawn_map(broken):
    def differs(map_):
        code = rooted_code(map_.sigma, map_.alpha, 0)
        return level(broken.enumerate, map_.edge_count)[code] != 1

    assert differs(find(SMALL, differs, settings=MANY))
