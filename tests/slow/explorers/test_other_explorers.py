"""The explorers that the paper compares with, and those that do without tests."""

import pytest

from explorers import test_other_explorers as quick
from small import slowest


@pytest.mark.parametrize("most", [6])
def test_with_one_marker_every_simple_world_is_mapped_within_the_bound(most):
    quick.test_with_one_marker_every_simple_world_is_mapped_within_the_bound(most)


@pytest.mark.parametrize("most", [slowest(4)])
def test_under_position_the_answer_is_a_map_exactly_where_only_one_looks_so(most):
    quick.test_under_position_the_answer_is_a_map_exactly_where_only_one_looks_so(most)
