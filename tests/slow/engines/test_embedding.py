"""A published S is a part of the world, or breaks a law; as the Python laws say."""

from random import Random

import pytest

from engines.test_embedding import grown, judge


@pytest.mark.long
def test_a_right_s_breaks_no_law():
    random = Random(1)
    for _ in range(30):
        map_, shown = grown(random)
        said, law = judge(shown, map_)
        assert (said[-1], law) == (0, 0)
