"""Wrong answers in words."""

from dataclasses import replace

import pytest

from allworlds.explaining import explain
from allworlds.inputs import InputError
from small import EDGE, LASSO


def test_a_lost_pose_says_where_the_robot_is_and_how_far_it_is_turned(told):
    law, step, text = told("pose-lost")
    assert (law, step) == ("pose", 1)
    # Two loops side by side, at dart 3; 'here' is dart 0, which the symmetry takes to dart 2.
    assert "stands at v0, dart 3; it believes to stand at dart 2 of the same vertex" in text
    assert "turned further by 1 of 4 darts clockwise" in text
    assert "symmetric: 1 other dart" in text


def test_a_robot_at_another_vertex_is_told_so(explained, answering):
    # A vertex of degree 3 with a loop and a leaf: no symmetry.
    explanation = explained(LASSO, answering(LASSO, 3, 0))
    assert explanation.law == "pose"
    assert "it believes to stand at v1, dart 3, which is another vertex" in explanation.sentences[1]


def test_a_pose_finding_whose_answer_is_another_map_is_refused(finding_of):
    finding = finding_of("pose-lost")
    with pytest.raises(InputError, match="not pose"):
        explain(replace(finding, seen={**EDGE.to_json(), "here": 0}))


@pytest.mark.parametrize("here", [99, -1, None, True, "0"])
def test_an_answer_without_a_place_is_refused(here, finding_of):
    finding = finding_of("pose-lost")
    with pytest.raises(InputError, match=r"seen\.here"):
        explain(replace(finding, seen={**finding.seen, "here": here}))
