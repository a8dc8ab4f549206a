"""The judge's own comparison against the second opinion, which shares no code with it.

The second opinion takes its time, so four edges, and all pairs of maps with three, are left to
``tests/slow`` but for a few; there they are cut into parts that can be done side by side.
"""

from functools import cache
from random import Random

import pytest

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.laws.law_table import Case
from allworlds.judging.walk import Walk
from allworlds.maps import CombinatorialMap, rooted_maps, unrooted_code
from allworlds.protocol.actions import Checkpoint, Estimate, Percept, Transcript
from allworlds.world import Directional, World
from second_opinion import verdict
from small import all_maps, slowest, stepped

PARTS = 8
EACH_PART = [slowest(4, PARTS, k) for k in range(PARTS)]
"""Edges, one world of so many, from the k-th."""

NOTHING_SENSED = Transcript(Percept(1))


@cache
def maps(m):
    return tuple(rooted_maps(m))


def judged(truth, dart, estimate, here):
    return Case(Walk.begin(World(truth, "none", dart)), (), Estimate(estimate, here)).answer


def agreed(truth, dart, estimate, here):
    """Require that both judges agree, and return their verdict."""
    first = judged(truth, dart, estimate, here)
    assert first == verdict(truth, dart, estimate, here), (truth, dart, estimate, here)
    return first


def shuffled(map_, random):
    names = list(map_.darts)
    random.shuffle(names)
    return map_.relabelled(names), names


@pytest.mark.parametrize(
    ("most", "parts", "k"),
    [(2, 1, 0)],
)
def test_on_every_pair_of_small_maps_and_every_pose(most, parts, k):
    # As truths all rooted maps stand for all maps and all darts.
    small = all_maps(most)
    seen = set()
    for truth in small[k::parts]:
        for estimate in small:
            outcomes = [agreed(truth, 0, estimate, here) for here in estimate.darts]
            assert not ({"map"} < set(outcomes)), "a map is the same or not, whatever the pose"
            seen.update(outcomes)
    assert seen == {"right", "pose", "map"}


@pytest.mark.parametrize("m", [1, 2])
def test_a_rooted_map_is_right_for_itself_alone(m):
    for i, truth in enumerate(maps(m)):
        right = [j for j, other in enumerate(maps(m)) if agreed(truth, 0, other, 0) == "right"]
        assert right == [i]


def unrooted(m):
    """One rooted map for each map, whatever its root."""
    return list({unrooted_code(map_): map_ for map_ in maps(m)}.values())


@pytest.mark.parametrize(("edges", "parts", "k"), [(3, 2, 0), *EACH_PART])
def test_on_every_map_against_itself_at_every_dart(edges, parts, k):
    random = Random(k)
    for truth in unrooted(edges)[k::parts]:
        estimate, names = shuffled(truth, random)
        outcomes = [agreed(truth, 0, estimate, names[here]) for here in truth.darts]
        assert outcomes[0] == "right"
        assert "map" not in outcomes


@pytest.mark.parametrize(("edges", "parts", "k"), [(3, 1, 0), *EACH_PART])
def test_on_every_rooted_map_against_itself_at_its_root(edges, parts, k):
    random = Random(k)
    for truth in maps(edges)[k::parts]:
        estimate, names = shuffled(truth, random)
        assert agreed(truth, 0, estimate, names[0]) == "right"


@pytest.mark.parametrize(("edges", "parts", "k"), [(4, 40, 0), *EACH_PART])
def test_on_every_map_against_its_mirror_image(edges, parts, k):
    # With three edges every map is its own mirror image.
    random = Random(k)
    seen = set()
    for truth in maps(edges)[k::parts]:
        estimate, names = shuffled(truth.mirrored(), random)
        seen.add(agreed(truth, 0, estimate, names[random.choice((0, 0, *truth.darts))]))
    assert seen == {"right", "pose", "map"}


@pytest.mark.parametrize(("pairs", "k"), [(10, 0)])
def test_on_pairs_of_maps_of_four_edges_with_the_same_degrees(pairs, k):
    # Other pairs are told apart by their degrees alone.
    random = Random(100 + k)
    for _ in range(pairs):
        truth = random.choice(maps(4))
        alike = [o for o in maps(4) if sorted(o.degrees) == sorted(truth.degrees)]
        estimate, _ = shuffled(random.choice(alike), random)
        agreed(truth, random.choice(truth.darts), estimate, random.choice(truth.darts))


@pytest.mark.parametrize(("pairs", "k"), [(10, 0)])
def test_on_a_map_whose_edge_has_been_reglued(pairs, k):
    """Two edges exchange their ends: the smallest error that keeps every vertex."""
    random = Random(200 + k)
    done = 0
    while done < pairs:
        truth = random.choice(maps(4))
        (a, b), (c, d) = random.sample(truth.edges, 2)
        alpha = list(truth.alpha)
        for x, y in ((a, c), (b, d)):
            alpha[x], alpha[y] = y, x
        try:
            estimate = CombinatorialMap(truth.sigma, alpha)
        except ValueError:
            continue  # no longer connected
        done += 1
        agreed(truth, 0, estimate, 0)


def answer(world):
    """Algorithm 1's estimate and the robot's dart when it answers."""
    generator = algorithm1(world.first)
    dart, reply = world.start, None
    while True:
        try:
            message = generator.send(reply)
        except StopIteration as stop:
            return stop.value, dart
        reply = None
        if not isinstance(message, Checkpoint):
            dart, reply = stepped(world, dart, message)


@pytest.mark.parametrize(("most", "parts", "k"), [(2, 1, 0), *EACH_PART])
def test_both_find_algorithm_1_right_in_every_world(most, parts, k):
    for map_ in all_maps(most)[k::parts]:
        for place in Directional.places(map_, 0):
            estimate, dart = answer(World(map_, place))
            assert agreed(map_, dart, estimate.map, estimate.here) == "right"
