"""The cost of Algorithm 1 beside the player's, in large worlds."""

import pytest

from allworlds.studies.run import LARGEST, play


@pytest.mark.slowest
def test_in_larger_worlds_algorithm1_is_not_run():
    assert play(f"cycle:{LARGEST}").algorithm1 > LARGEST
    assert play(f"cycle:{LARGEST + 1}").algorithm1 is None
