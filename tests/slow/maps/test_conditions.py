"""Conditions that narrow a class of maps, compared with all permutations."""

import pytest
import test_conditions as quick
from test_conditions import NAMES, TOGETHER

from small import slowest


@pytest.mark.parametrize("edges", [4, slowest(6)])
@pytest.mark.parametrize("name", TOGETHER)
def test_several_conditions_leave_what_each_of_them_leaves(name, edges):
    quick.test_several_conditions_leave_what_each_of_them_leaves(name, edges)


@pytest.mark.parametrize("edges", [4])
@pytest.mark.parametrize("name", NAMES)
def test_a_condition_leaves_what_filtering_all_permutations_leaves(name, edges):
    quick.test_a_condition_leaves_what_filtering_all_permutations_leaves(name, edges)
