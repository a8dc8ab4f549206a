"""Wrong checkpoints in words."""

import pytest


@pytest.mark.parametrize(
    ("name", "law"), [("place-shown-wrong", "invariant-1"), ("partner-shown-in-U", "invariant-2")]
)
def test_a_wrong_checkpoint_is_told_with_its_step(name, law, told):
    found, step, text = told(name)
    assert (found, step) == (law, 1)
    assert "checkpoint came after step 1, where the robot stood at v0, dart 1" in text


def test_a_pass_without_progress_is_told(told):
    law, step, text = told("pass-without-progress")
    assert (law, step) == ("variant", None)
    assert "no progress" in text
    assert "after step 1" in text
