"""The search of one world in this process."""

import pytest

from allworlds.inputs.checks import InputError
from allworlds.protocol.actions import End, Move
from allworlds.protocol.turns import Automaton
from allworlds.robots.graph import MOST_ROBOTS
from allworlds.robots.models.one_interval import OneInterval
from allworlds.robots.single_search import search
from small import EDGE
from worlds_that_change import Never


def test_programs_that_are_equal_but_for_a_type_are_two():
    """Automata that begin with 1 and with True are equal values."""

    def end(memory, percept):
        return memory, End(memory)

    team = [Automaton(start, end) for start in (1, True)]
    found = search(EDGE, (0, 1), Never(), team, "fsync")
    _, minds, _ = found.search.configuration(len(found.search) - 1)
    answers = [found.search.minds.value[mind].answer for mind in minds]
    assert [*map(repr, answers)] == ["1", "True"]


def test_more_robots_than_a_set_of_them_has_bits_are_refused():
    """With a bit too few the step of all robots would lead to another configuration."""
    walk = Automaton(0, lambda memory, _: (memory, Move(0)))

    def searched(robots):
        return search(EDGE, (0,) * (robots - 1) + (1,), Never(), [walk] * robots, "fsync")

    assert searched(MOST_ROBOTS).law == "progress"
    with pytest.raises(InputError, match="robots = 13 are more than 12"):
        searched(MOST_ROBOTS + 1)


def test_a_scheduler_that_the_model_has_not_and_starts_of_others_are_refused():
    walk = Automaton(0, lambda memory, _: (memory, Move(0)))
    with pytest.raises(InputError, match="scheduler 'async' is not one of fsync, ssync"):
        search(EDGE, (0,), OneInterval(), [walk], "async")
    with pytest.raises(InputError, match=r"starts = \(0, 1\) are not 1, one for each robot"):
        search(EDGE, (0, 1), OneInterval(), [walk])


def test_an_automaton_without_a_memory_at_the_start_breaks_a_law_before_any_step():
    def begins(told):
        raise ValueError("no")

    walks = Automaton(0, lambda memory, _: (memory, Move(0)))
    fails = Automaton(begins, lambda memory, _: (memory, Move(0)))
    found = search(EDGE, (0, 1), Never(), [walks, fails], "fsync")
    assert (found.law, found.events, found.search.broken.robot) == ("crash", (), 1)


def test_two_robots_may_start_at_all_darts_of_a_face():
    assert [*OneInterval(one_face=True).starts(EDGE, 2)] == [*OneInterval().starts(EDGE, 2)]
    assert (0, 1) in OneInterval(one_face=True).starts(EDGE, 2)
