"""Slips that are recognised: each claim is compared with what was done to a right answer."""

import pytest

from allworlds import CombinatorialMap, Move
from allworlds.checker import check, run
from allworlds.explaining import Belief, Story, explain
from allworlds.explaining.slips import LARGEST, SLIPS, tell_slip
from allworlds.explorers import algorithm1
from allworlds.judge.second_opinion import same_map
from allworlds.maps.canonical import isomorphism, rooted_isomorphism
from allworlds.maps.families import family
from allworlds.maps.surgery import contracted, deleted
from allworlds.mutation.explorers import WRONG_EXPLORERS
from allworlds.protocol import Estimate
from allworlds.world import Directional, World


def spoiling(spoil):
    """Algorithm 1, whose answer is spoiled; as it is where there is nothing to spoil."""

    def explore(first):
        estimate = yield from algorithm1(first)
        return spoil(estimate) or estimate

    return explore


def mirrored(estimate):
    return Estimate(estimate.map.mirrored(), estimate.here)


def exchanged(estimate):
    """Two neighbouring darts of the first vertex where this makes another map."""
    map_ = estimate.map
    for a in map_.darts:
        b, alpha = map_.sigma[a], [*map_.alpha]
        if a == b or alpha[a] == b:
            continue
        x, y = alpha[a], alpha[b]
        alpha[a], alpha[b], alpha[x], alpha[y] = y, x, b, a
        spoiled = CombinatorialMap(map_.sigma, alpha) if _connected(map_.sigma, alpha) else None
        if spoiled and not isomorphism(spoiled, map_):
            return Estimate(spoiled, estimate.here)
    return None


def _connected(sigma, alpha):
    reached, todo = {0}, [0]
    for d in todo:
        for e in (sigma[d], alpha[d]):
            if e not in reached:
                reached.add(e)
                todo.append(e)
    return len(reached) == len(sigma)


def without_an_edge(estimate):
    fewer = (deleted(estimate.map, d) for d in estimate.map.darts)
    smaller = next((map_ for map_ in fewer if map_), None)
    return Estimate(smaller, 0) if smaller else None


def with_one_vertex_for_two(estimate):
    fewer = (contracted(estimate.map, d) for d in estimate.map.darts)
    smaller = next((map_ for map_ in fewer if map_), None)
    return Estimate(smaller, 0) if smaller else None


def with_a_leaf_more(estimate):
    size = len(estimate.map.sigma)
    sigma = [*estimate.map.sigma, size, size + 1]
    sigma[size], sigma[0] = sigma[0], size
    return Estimate(CombinatorialMap(sigma, [*estimate.map.alpha, size + 1, size]), 0)


CASES = {
    "mirrored": (mirrored, "mirror image"),
    "exchanged": (exchanged, "One slip makes all the difference"),
    "without an edge": (without_an_edge, "The answer lacks one edge of the world"),
    "one vertex for two": (with_one_vertex_for_two, "for one vertex"),
    "a leaf more": (with_a_leaf_more, "one edge too many"),
}


@pytest.mark.parametrize("name", CASES)
def test_a_spoiled_answer_is_told_by_its_slip_in_every_small_world(name):
    spoil, words = CASES[name]
    findings = check(spoiling(spoil), edges=3, max_findings=1000, laws=("map", "pose")).findings
    told = [" ".join(tell_slip(Belief(Story(finding)))) for finding in findings]
    assert len(told) > 10
    # What was done can often be undone in another way, too, but it is never without a name.
    assert all(told)
    assert any(words in sentence for sentence in told)
    if name == "mirrored":
        assert all(words in sentence for sentence in told)


@pytest.mark.parametrize("mutant", WRONG_EXPLORERS, ids=lambda mutant: mutant.name)
def test_a_mirror_image_is_claimed_exactly_where_there_is_one(mutant):
    for finding in check(mutant.explorer(), edges=3, max_findings=20).findings:
        if finding.law not in ("map", "pose"):
            continue
        belief = Belief(Story(finding))
        claimed = bool(SLIPS["mirrored"](belief))
        answer, robot = belief.answer, belief.story.walked[-1]
        image = CombinatorialMap(*map(list, (_inverse(answer.map.sigma), answer.map.alpha)))
        rooted = rooted_isomorphism(image, answer.here, finding.world.map, robot)
        alone = finding.law == "map" and same_map(image, finding.world.map)
        assert claimed == (bool(rooted) or alone), finding


def _inverse(sigma):
    inverse = [0] * len(sigma)
    for d, e in enumerate(sigma):
        inverse[e] = d
    return inverse


def test_the_slip_stands_in_the_explanation():
    (finding,) = check(spoiling(mirrored), edges=4, laws=("map", "pose")).findings
    assert any("mirror image" in sentence for sentence in explain(finding).sentences)


def test_an_exchange_is_told_in_the_darts_of_the_world():
    # A star of three leaves whose second and third dart are at loops' ends: only orders differ.
    findings = check(spoiling(exchanged), edges=3, max_findings=1000, laws=("map",)).findings
    for finding in findings:
        (sentence,) = tell_slip(Belief(Story(finding)))
        told = [
            int(word)
            for word in sentence.replace(",", " ").replace(".", " ").split()
            if word.isdigit()
        ]
        assert set(told) <= set(finding.world.map.darts)


def test_nothing_is_looked_for_in_large_maps():
    world = World(family(f"cycle:{LARGEST + 1}"), Directional(0))

    def explore(_):
        yield Move(0)
        return Estimate(family("cycle:3"), 0)

    assert tell_slip(Belief(Story(run(explore, world).finding))) == []
