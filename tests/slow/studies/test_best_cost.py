"""The least and the largest cost of a world over every schedule, in the rows of ``check``."""

import pytest

from allworlds import check
from native_libraries import example
from small import slowest
from studies import test_best_cost as quick


def test_a_user_s_explorer_that_is_played_twice_has_the_same_costs():
    name = f"native:{example('c/algorithm1.c')}"
    users, own = (check(one, edges=2, schedules="all") for one in (name, "algorithm1"))
    assert users.rows == own.rows


@pytest.mark.parametrize("edges", [slowest(3)])
def test_the_costs_are_those_of_every_schedule_played_by_hand(edges):
    quick.test_the_costs_are_those_of_every_schedule_played_by_hand(edges)
