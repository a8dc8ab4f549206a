"""Runs that ended before they could be judged, in words."""

from dataclasses import replace

import pytest

from allworlds.explaining import explain


def test_a_crash_is_told_with_its_last_step_and_the_last_line_of_the_traceback(told):
    law, _, text = told("crashes-at-leaves")
    assert law == "crash"
    assert "step 1, move 0: to v1, dart 1, where it sensed 'degree 1'" in text
    assert text.endswith("stderr: IndexError: a vertex without another dart")


def test_a_run_that_ends_at_the_start_has_no_last_step(told):
    law, _, text = told("drops-markers")
    assert law == "illegal-action"
    assert "It made no step" in text
    assert "Seen was: Drop()." in text


@pytest.mark.parametrize(
    ("name", "law", "words"),
    [
        ("no-answer", "no-estimate", "Seen was: None."),
        ("never-stops", "budget", "Seen was: traversal 109."),
        ("state-kept", "nondeterministic", "differs at step 1"),
    ],
)
def test_other_endings_say_what_was_expected_and_seen(name, law, words, told):
    found, step, text = told(name)
    assert (found, step) == (law, None)
    assert "Expected was: " in text
    assert words in text


def test_a_timeout_is_told(finding_of):
    finding = replace(finding_of("crashes-at-leaves"), law="timeout", seen="silent", detail="")
    text = " ".join(explain(finding).sentences)
    assert "silent for too long" in text
    assert "The last line" not in text
