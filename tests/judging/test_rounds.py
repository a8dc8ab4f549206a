"""Walks that come to no end."""

from itertools import cycle, islice

import pytest

from allworlds import Move
from allworlds.judging import explain
from allworlds.judging.explanations.rounds import LONGEST, Round, round_at_the_end
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
    assert told[1].startswith("From step 1 on it went round: ")
    length = int(told[1].split()[7])
    assert length in (3, 4)  # the degree of the face, and perhaps its vertices
    assert len(told) == 2


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

    (_, told) = explained(in_one_face, "cube")
    assert told.endswith("it met no new edge; 8 edges it never met.")
