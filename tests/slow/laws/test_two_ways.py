"""Two judges and two enumerators that share no code say the same of whatever is drawn."""

import pytest
from hypothesis import find, given, settings

from allworlds.maps import isomorphism
from laws.test_two_ways import MANY, SMALL, answers, judged
from second_opinion import verdict


@pytest.mark.slowest
def test_a_judge_that_takes_mirror_images_for_the_same_would_be_noticed():
    def soft(truth, dart, estimate, here):
        said = judged(truth, dart, estimate, here)
        return "right" if said == "map" and isomorphism(estimate.mirrored(), truth) else said

    def noticed(map_):
        answer = map_, 0, map_.mirrored(), 0
        return soft(*answer) == "right" and verdict(*answer) == "map"

    # Every map with fewer edges is its own mirror image.
    assert find(SMALL, noticed, settings=MANY).edge_count == 4


@settings(max_examples=100)
@given(answers())
def test_both_judges_say_the_same_of_every_answer(answer):
    assert judged(*answer) == verdict(*answer)
