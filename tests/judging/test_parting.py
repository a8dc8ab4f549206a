"""Where belief and truth part, in words."""

import pytest

from allworlds import CombinatorialMap
from allworlds.maps import from_cycles
from small import EDGE, LOOP, PATH, TRIANGLE


def test_a_known_place_taken_for_a_new_vertex_is_where_they_part(told):
    law, step, text = told("wrong-entry-label")
    assert (law, step) == ("map", 2)
    assert "back at v1" in text
    assert "takes this vertex for a new one" in text
    # The wrong place is sensed to be wrong only later.
    assert "answer is first contradicted at step 7" in text


def test_a_known_place_left_some_time_ago_is_named_with_the_step(explained, answering):
    # A triangle on a stalk, walked once round; the answer goes on instead of closing it.
    world = from_cycles(["a", "abd", "bc", "cd"])
    answer = from_cycles(["a", "abe", "bc", "cd", "dfg", "e", "f", "g"])
    explanation = explained(world, answering(answer, 8, 0, 1, 1, 1))
    assert explanation.step == 4
    text = " ".join(explanation.sentences)
    assert "step 4 the robot was back at v1, which it had left at step 2, but its answer " in text
    assert "takes this vertex for a new one" in text
    assert "Every percept fits the answer, too" in text
    assert "After this walk it is not known where dart " in text


def test_a_new_vertex_taken_for_a_known_one_is_where_they_part(explained, answering):
    answer = CombinatorialMap([1, 0, 3, 2], [2, 3, 0, 1])
    explanation = explained(TRIANGLE, answering(answer, 2, 0, 1, 1))
    assert explanation.step == 2
    text = " ".join(explanation.sentences)
    assert "step 2 the robot came to v2 for the first time" in text
    assert "takes this vertex for v0, which it had left at step 1" in text


def test_another_dart_of_the_same_vertex_is_where_they_part(told):
    law, step, text = told("bearing-ignored")
    assert (law, step) == ("map", 1)
    # The two loops cross: in truth the robot comes out at dart 2.
    assert "in its answer it came in by dart 1, in truth by dart 2" in text
    assert "the robot sensed 'degree 4, marked, bearing 2'" in text


def test_a_start_of_another_degree_parts_at_once(explained, answering):
    explanation = explained(LOOP, answering(EDGE, 0))
    assert explanation.step == 0
    assert "differ at the start, at v0" in explanation.sentences[-1]


@pytest.mark.parametrize(("motions", "missing"), [((0,), "2 and 3"), ((0, 1), "2 and 3")])
def test_the_missing_edge_is_the_one_that_was_walked_last_or_never(
    explained, answering, motions, missing
):
    slip, *_ = explained(PATH, answering(EDGE, 1, *motions)).sentences
    assert slip == f"The answer lacks one edge of the world: the edge of darts {missing}."


def test_of_edges_that_were_never_walked_the_missing_one_is_the_first(explained, answering):
    star = CombinatorialMap((1, 2, 0, 3, 4, 5), (3, 4, 5, 0, 1, 2))
    slip, *_ = explained(star, answering(PATH, 0)).sentences
    assert slip == "The answer lacks one edge of the world: the edge of darts 0 and 2."


def test_an_answer_that_fits_the_log_never_parts_and_its_open_darts_are_counted(
    explained, answering
):
    explanation = explained(PATH, answering(EDGE, 0))
    assert explanation.step is None
    slip, guessed, open_darts = explanation.sentences
    assert slip == "The answer lacks one edge of the world: the edge of darts 0 and 1."
    assert guessed.startswith("The answer is another world that fits the whole log")
    assert open_darts == "After this walk it is not known where dart 0 of v0 leads."
