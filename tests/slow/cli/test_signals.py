"""Signals at two hundred drawn moments."""

import pytest

from cli import test_signals as quick

undisturbed = quick.undisturbed


@pytest.mark.slowest
@pytest.mark.processes
@pytest.mark.parametrize("seed", range(100, 300))
def test_a_signal_at_any_moment_interrupts_or_changes_nothing(undisturbed, tmp_path, seed):
    quick.test_a_signal_at_any_moment_interrupts_or_changes_nothing(undisturbed, tmp_path, seed)
