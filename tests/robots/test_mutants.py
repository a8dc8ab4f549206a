"""Faults of the search: the second opinions notice each."""

from itertools import product

import pytest

from allworlds.protocol.actions import Watch
from allworlds.robots.model import SCHEDULERS
from fair_runs import agree_on_cycles
from one_by_one import agree
from several_robots import SEARCHES
from small import EDGE, PATH
from worlds_that_change import CASES, GATES, WORLDS, Together, automata, patient


def opinions():
    """Compare a mixed team, some cycles, and some schedules."""
    every = [*automata(), *automata(Watch())]
    for scheduler in SCHEDULERS:
        agree(
            PATH, (0, 3), Together(labels=True, aim="FG"), [patient, every[0]], scheduler, budget=2
        )
    for number, (world, scheduler) in enumerate(product([*WORLDS, *GATES], SCHEDULERS)):
        for automaton in every[number % 61 :: 61]:
            agree_on_cycles(world, scheduler, automaton)
    for case, scheduler in product(CASES, SCHEDULERS):
        model, program, most = CASES[case]
        for map_ in (EDGE, PATH)[:most]:
            for starts in [*model.starts(map_, 2)][:3]:
                agree(map_, starts, model, [program] * 2, scheduler)


def test_without_a_fault_all_agree():
    opinions()


@pytest.mark.parametrize("mutant", SEARCHES)
def test_a_search_with_a_fault_is_noticed(mutant, monkeypatch):
    mutant(monkeypatch)
    with pytest.raises((AssertionError, LookupError)):
        opinions()
