"""Tasks, predicates and lighthouses that end the process: its exit code is never theirs."""

import pytest

from cli import test_ending_models as quick

ended = quick.ended


@pytest.mark.parametrize(
    ("end", "kind", "more", "code"),
    [("os._exit, 0", "where", ["--bound", "0", "--json"], 1), ("os._exit, 1", "where", [], 0)],
)
def test_the_exit_code_is_that_of_the_verdict_whatever_a_model_does_at_the_end(
    ended, end, kind, more, code
):
    quick.test_the_exit_code_is_that_of_the_verdict_whatever_a_model_does_at_the_end(
        ended, end, kind, more, code
    )
