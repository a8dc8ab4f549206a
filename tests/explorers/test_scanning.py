"""Algorithm 1 where one letter is sensed at v0: behind a door, and with a word."""

from itertools import islice, product

import pytest

import allworlds
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.builtin.scanning import algorithm1_door, telling
from allworlds.judging.laws.bounds import bound_named, paper_bound
from allworlds.maps import CombinatorialMap, from_cycles, from_rotation, named_map
from allworlds.maps.build import cycle
from allworlds.protocol.actions import Checkpoint
from allworlds.protocol.choices import Choices
from allworlds.world import Door
from schedules import schedules
from small import EDGE, LOOP, all_maps

DOOR, WORD = "algorithm1-door", "algorithm1-word"


def events(map_, choices, place):
    """The events of a run from dart 0."""
    met, percepts = set(), place.percepts(map_)
    run, here, answer = algorithm1_door(percepts[0], choices=choices, notice=met.add), 0, None
    try:
        while True:
            message, answer = run.send(answer), None
            if not isinstance(message, Checkpoint):
                here = map_.alpha[map_.turn(here, message.k)]
                answer = percepts[here]
    except StopIteration:
        return met


def test_a_door_is_enough_within_its_bound():
    report = allworlds.check(DOOR, edges=3, workers=1)
    assert (report.verdict.value, report.worlds, report.runs) == ("holds", 86, 309)
    assert report.traversals == 3_787  # the search ends at the door
    assert {"bound", "invariant-1", "invariant-2", "variant"} <= set(report.scope.laws)
    assert report.scope.lighthouse == "door"


def test_the_bound_of_the_door_is_two_more_for_each_test_and_the_search():
    bound = bound_named(BUILT_IN[DOOR].bound)
    for map_ in all_maps(4):
        n, m, d0 = map_.vertex_count, map_.edge_count, map_.degree_at[0]
        growing = sum(s + 2 * s * (2 * m - 2 * (s - 1)) for s in range(1, n))
        closing = sum(n + 2 * n * (2 * m - 2 * (n - 1) - 2 * (i - 1)) for i in range(1, m - n + 2))
        assert bound.of(map_, 0) == growing + closing + 2 * (d0 - 1) > paper_bound(n, m)


@pytest.mark.parametrize("pattern", ["120*", "10*", "0*12", "13*"])
def test_a_word_without_period_is_enough(pattern):
    report = allworlds.check(WORD, edges=2, lighthouse=f"word:{pattern}", workers=1)
    assert (report.verdict.value, report.runs) == ("holds", 30)


@pytest.mark.parametrize(("pattern", "edges"), [("12", 2), ("1", 2), ("0", 2)])
def test_a_word_that_is_a_power_or_blank_is_refuted(pattern, edges):
    (finding,) = allworlds.check(WORD, edges=edges, lighthouse=f"word:{pattern}").findings
    assert (finding.world.map.edge_count, finding.world.map.vertex_count) == (edges, 1)


@pytest.mark.parametrize(
    ("letters", "dart", "darts"),
    [
        ([1, 0, 0], 0, []),  # the door itself
        ([1, 0, 0], 2, [0]),
        ([0, 0, 0, 1], 1, [3]),
        ([1, 1, 0], 0, [1]),
        ([1, 1, 0], 2, [0]),
        ([1, 1, 1, 0, 0], 0, [2]),
        ([1, 2, 3], 1, []),
        ([1], 0, []),
        ([1, 1], 0, []),  # nothing tells
        ([0, 0], 1, []),
    ],
)
def test_few_letters_tell_by_which_dart_the_robot_has_come(letters, dart, darts):
    assert telling(letters, dart) == darts


def test_the_letters_asked_fit_no_word_but_the_same():
    for degree in range(1, 7):
        for letters in map(list, product((0, 1), repeat=degree)):
            shifts = [letters[k:] + letters[:k] for k in range(1, degree)]
            others = [word for word in (*shifts, [0] * degree) if word != letters]
            for dart in range(degree):
                asked = [dart, *telling(letters, dart)]
                assert not any(all(word[d] == letters[d] for d in asked) for word in others)


# A square with a diagonal; v0 is an end of it, and the door is the dart 2.
SQUARE = CombinatorialMap((1, 2, 0, 4, 3, 6, 5, 8, 9, 7), (3, 5, 7, 0, 8, 1, 9, 2, 4, 6))

# For each event that is required a world in which every sequence of choices meets it.
FORCED = {
    ("case-1", False): from_cycles(["a", "ab", "bcd", "cde", "e"]),
    ("case-2", False): from_cycles(["abc", "abc"]),
    ("case-3", False): LOOP,
    ("empty-H", False): EDGE,
    ("loop", False): LOOP,
    ("non-loop", False): EDGE,
    ("v0-hypothesis", False): LOOP,
    ("case-1", True): from_rotation(
        [[1], [0, 2, 7], [1, 3, 4], [2, 5], [2, 5], [3, 4, 6], [5], [1]]
    ),
    ("case-2", True): SQUARE,
    ("case-3", True): cycle(3),
    ("empty-H", True): EDGE,
    ("loop", True): cycle(3),
    ("non-loop", True): EDGE,
    ("v0-hypothesis", True): named_map("k4"),
}


@pytest.mark.parametrize(("event", "simple"), FORCED)
def test_no_policy_can_miss_a_witness_in_a_world_of_the_stated_size(event, simple):
    map_ = FORCED[event, simple]
    assert BUILT_IN[DOOR].witnesses[event][simple] == (map_.edge_count, map_.vertex_count)
    assert map_.is_simple or not simple
    place = Door(2 if map_ is SQUARE else 0)
    for choices in islice(schedules(), 40):
        assert event in events(map_, choices, place)


def test_every_witness_has_such_a_world():
    assert {event for event, _ in FORCED} == set(BUILT_IN[DOOR].witnesses)
    assert events(named_map("k4"), Choices(), Door(2)) >= {"loop", "non-loop", "v0-hypothesis"}
