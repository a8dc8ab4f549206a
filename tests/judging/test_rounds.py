"""Walks that come to no end."""

from itertools import count, cycle, islice
from math import isqrt

import pytest

from allworlds import Move
from allworlds.judging import explain
from allworlds.judging.explanations.rounds import LONGEST, WAY_BACK, Round, round_at_the_end
from allworlds.studies.run import run
from allworlds.world import world_named


@pytest.mark.parametrize(
    ("steps", "found"),
    [
        ("", None),
        ("ab", None),
        ("aaa", Round(1, 1, 3)),
        ("xabab", None),
        ("abcdefgxyznnn", None),
        ("xababab", Round(2, 2, 3)),
        ("xyababababa", Round(3, 2, 5)),
        ("aabaabaab", Round(1, 3, 3)),
        ("aabaabaabc", None),
    ],
)
def test_the_shortest_round_at_the_end_is_found_with_its_beginning(steps, found):
    assert round_at_the_end(steps) == found


def test_a_round_longer_than_is_looked_for_is_none():
    length = LONGEST + 1
    assert round_at_the_end([*islice(cycle(range(length)), 4 * length)]) is None
    assert round_at_the_end([*islice(cycle(range(LONGEST)), 4 * LONGEST)]).length == LONGEST


def explained(explore, world):
    finding = run(explore, world_named(world, "directional")).finding
    assert finding.law == "budget"
    return explain(finding).sentences


def test_who_walks_round_a_face_is_told_so():
    def round_and_round(first):
        del first
        while True:
            yield Move(1)

    told = explained(round_and_round, "k4")
    assert told[1].startswith("From step 1 on it repeated ")
    length = int(told[1].split()[6])
    assert length in (3, 4)  # the degree of the face, and perhaps its vertices
    assert len(told) == 3
    assert "8 times the paper's bound, and 100 more: 8 x (" in told[2]
    assert "--step-budget N" in told[2]


def test_who_wanders_is_told_when_nothing_was_new_any_more():
    def wandering(first):
        del first
        n = 0
        while True:
            n += 1
            yield Move(int(n**0.5 // 1) % 3)

    told = explained(wandering, "k4")
    assert "it had walked every edge of the world, and yet it went on" in told[1]


def test_edges_that_were_never_walked_are_counted():
    def in_one_face(first):
        del first
        n = 0
        while True:  # round a face, and then to and fro along its edge, each time once more
            n += 1
            for _ in range(4):
                yield Move(1)
            for _ in range(2 * n):
                yield Move(0)

    _, told, back, _ = explained(in_one_face, "cube")
    assert told.endswith("it met no new edge; 8 edges it never met.")
    assert back.startswith("If a way back begins at step 5: motions a, b, c are undone")


def retracing(way_back):
    """Explore a bouquet for ever: out by two motions and back, after which the next door is due."""

    def explore(first):
        k = 0
        while True:
            for motion in (k, 1, *way_back(k)):
                yield Move(motion)
            k += 1

    return explore


def test_the_rule_of_ways_back_that_is_told_is_true():
    world = world_named("theta", "directional")
    walked = [world.start]
    motions = (1, 2, 1)
    for k in (*motions, *(0, -1, -2)):
        walked.append(world.map.alpha[world.map.turn(walked[-1], k)])
    # It stands at the dart by which it left: motions[0] clockwise of the one where it stood.
    assert walked[-1] == world.map.turn(walked[0], motions[0])
    assert "undone by 0, -c, -b" in WAY_BACK


def test_a_wrong_way_back_is_named_where_every_edge_was_walked():
    told = explained(retracing(lambda k: (0, 1, 2)), "theta")
    assert f"If a way back begins at step 3: {WAY_BACK}." in told

    def forgetting(_):
        for k in count():
            for motion in (isqrt(k), 1, 0):
                yield Move(motion)

    _, walked, why, back, _ = explained(forgetting, "theta")
    assert "it had walked every edge of the world" in walked
    assert "the robot is not where the explorer believes" in why
    assert back == f"If a way back begins at step 3: {WAY_BACK}."


def test_the_budget_that_was_asked_for_is_told_as_that():
    def to_and_fro(_):
        while True:
            yield Move(0)

    told = explain(
        run(to_and_fro, world_named("theta", "directional"), step_budget=7).finding
    ).sentences
    assert told[-1] == "The budget is that of --step-budget: 7 traversals."
