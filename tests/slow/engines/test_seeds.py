"""Both plays have hash seeds of their own, and there are not too many of them."""

import pytest

from engines import test_seeds as quick

pytestmark = pytest.mark.processes


@pytest.mark.parametrize(("edges", "workers"), [(1, 1), (2, 2), (4, 1)])
def test_there_are_two_plays_a_run_and_more_under_other_seeds(tmp_path, edges, workers):
    quick.test_there_are_two_plays_a_run_and_more_under_other_seeds(tmp_path, edges, workers)


@pytest.mark.parametrize(
    ("later", "outcome", "plays"),
    [("False", ("not-reproduced", 3), 16)],
)
def test_a_run_that_is_the_same_again_does_not_show_that_it_always_is(
    tmp_path, later, outcome, plays
):
    quick.test_a_run_that_is_the_same_again_does_not_show_that_it_always_is(
        tmp_path, later, outcome, plays
    )
