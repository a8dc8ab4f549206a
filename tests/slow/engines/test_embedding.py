"""An S that goes on from one that is known is judged as if nothing were known."""

from random import Random

from engines.test_embedding import grown, judge


def test_a_right_s_is_embedded_step_by_step():
    random = Random(1)
    for _ in range(30):
        map_, shown = grown(random)
        said, remembered, law = judge(shown, map_)
        assert (said[-1][0], law) == (0, 0)
        assert remembered == len(shown)
