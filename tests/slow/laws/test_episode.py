"""The episode against a model of a few lines, whatever an explorer does in whatever order."""

import pytest
from hypothesis.stateful import run_state_machine_as_test

from laws.test_episode import STATEFUL, Machine


@pytest.mark.slowest
def test_an_episode_is_what_a_tiny_model_says_whatever_the_explorer_does():
    run_state_machine_as_test(Machine, settings=STATEFUL)
