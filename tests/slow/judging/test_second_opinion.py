import random
from itertools import permutations

import pytest

from allworlds.maps import CombinatorialMap, InvalidMap
from judging.test_second_opinion import drawn
from second_opinion import same_map, same_pose, verdict


def dart_isomorphisms(a, b):
    """By trying every bijection of darts."""
    if len(a.sigma) != len(b.sigma):
        return []
    return [
        names
        for names in permutations(a.darts)
        if all(
            names[a.sigma[d]] == b.sigma[names[d]] and names[a.alpha[d]] == b.alpha[names[d]]
            for d in a.darts
        )
    ]


def all_maps(edges):
    alpha = [d ^ 1 for d in range(2 * edges)]
    for sigma in permutations(range(2 * edges)):
        try:
            yield CombinatorialMap(sigma, alpha)
        except InvalidMap:
            continue


def agree_on(a, b):
    """Assert that the judge and the bijections agree on the pair; return whether it is one map."""
    found = dart_isomorphisms(a, b)
    assert same_map(a, b) == bool(found)
    for here_a in a.darts:
        for here_b in b.darts:
            pose = any(names[here_a] == here_b for names in found)
            assert same_pose(a, here_a, b, here_b) == pose
            expected = "right" if pose else "pose" if found else "map"
            assert verdict(a, here_a, b, here_b) == expected
    return bool(found)


@pytest.mark.slowest
def test_the_judge_agrees_with_all_dart_bijections_on_up_to_two_edges():
    maps = [*all_maps(1), *all_maps(2)]
    outcomes = {agree_on(a, b) for a in maps for b in maps}
    assert outcomes == {True, False}


@pytest.mark.slowest
def test_the_judge_agrees_with_all_dart_bijections_on_some_pairs_with_three_edges():
    maps = list(all_maps(3))
    rng = random.Random(3)
    outcomes = []
    for _ in range(10):
        a, b = rng.sample(maps, 2)
        outcomes.append(agree_on(a, b))
        outcomes.append(agree_on(a, a.mirrored()))
    assert set(outcomes) == {True, False}


@pytest.mark.parametrize(
    "a",
    [
        drawn("aabbccdd"),
        drawn("abcdabcd"),
        drawn("abcd", "abcd"),
        drawn("abcc", "bad", "d"),
    ],
)
def test_relabelling_the_darts_gives_the_same_map_and_takes_the_pose_along(a):
    rng = random.Random(4)
    for _ in range(5):
        names = rng.sample(a.darts, len(a.darts))
        here = rng.choice(a.darts)
        assert verdict(a, here, a.relabelled(names), names[here]) == "right"
