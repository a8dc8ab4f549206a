"""The search against a second opinion: plain recursion, in which nothing is merged."""

import pytest

from allworlds.protocol.actions import Move, Wait, Watch
from allworlds.protocol.turns import Automaton
from allworlds.robots.model import SCHEDULERS
from allworlds.robots.models.meeting import Meeting
from allworlds.robots.single_search import search
from one_by_one import agree
from small import EDGE, PATH, TRIANGLE, all_maps
from worlds_that_change import CASES, MEETING, Never, steps


@pytest.mark.parametrize("scheduler", SCHEDULERS)
@pytest.mark.parametrize("case", CASES)
def test_schedules_one_by_one_are_as_many_and_end_alike(case, scheduler):
    model, program, most = CASES[case]
    tried = 0
    for map_ in all_maps(most if scheduler in ("fsync", "central") else min(most, 2)):
        for starts in model.starts(map_, 2):
            tried += agree(map_, starts, model, [program] * 2, scheduler)
    assert tried


@pytest.mark.parametrize("lead", [1, 2])
@pytest.mark.parametrize("scheduler", ["ssync", "central", "async"])
@pytest.mark.parametrize("case", ["never out of step", "watches", "switches", "shoots"])
def test_schedules_with_a_lead_are_as_many_and_end_alike(case, scheduler, lead):
    model, program, _ = CASES[case]
    for map_ in (EDGE, PATH):
        for starts in model.starts(map_, 2):
            agree(map_, starts, model, [program] * 2, scheduler, lead=lead)


def test_central_runs_with_a_lead_are_async_runs_with_it():
    """A robot that is ahead finishes its motion before others look."""
    for scheduler in ("central", "async"):
        found = search(EDGE, (0, 1), MEETING, [step_once] * 2, scheduler, lead=1)
        places = {found.search.states[key[0]].darts for key in found.search._keys}
        assert (1, 1) in places, "robot 0 moves before robot 1 looks"


def test_a_team_of_three():
    for scheduler in SCHEDULERS:
        for start in ((0, 1, 1), (0, 1, 3), (2, 4, 5)):
            agree(TRIANGLE, start, Meeting(apart=False), [steps] * 3, scheduler, budget=1)


def step_once(first):
    yield Move(1)


def wait_for_ever(first):
    while True:
        yield Wait()


@pytest.mark.parametrize("scheduler", SCHEDULERS)
def test_a_sleeper_that_is_waited_for_is_no_deadlock(scheduler):
    """Robot 0 watches at once; robot 1 begins later, and comes."""
    found = search(EDGE, (0, 1), MEETING, [watch, step_once], scheduler, start_delay=2)
    assert found.holds


def watch(first):
    yield Watch()
    yield Watch()


walks = Automaton(None, lambda memory, percept: (memory, Move(1)))
waits = Automaton(None, lambda memory, percept: (memory, Wait()))


@pytest.mark.parametrize("scheduler", ["ssync", "central", "async"])
@pytest.mark.parametrize("automaton", [walks, waits])
def test_in_a_mixed_team_the_budget_is_that_of_each(automaton, scheduler):
    """Else the automaton would go on for ever, and the run of the other one never be cut off."""
    found = search(PATH, (0, 1), Never(), [wait_for_ever, automaton], scheduler, budget=3)
    assert (found.law, bool(found.unfinished)) == ("", True)
    assert found.schedules is None
    alone = search(PATH, (0, 1), Never(), [automaton] * 2, scheduler, budget=3)
    assert (alone.law, alone.unfinished) == ("progress", 0)
