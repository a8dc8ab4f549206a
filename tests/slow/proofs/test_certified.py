"""The comparison with the certified explorers can fail: other programs take their place."""

import sys

import pytest

from proofs import test_certified as quick
from proofs.test_certified import IMPOSTOR, compared

certified = quick.certified


@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest"])
@pytest.mark.parametrize("pair", [0, 1, 2])
def test_the_same_explorer_in_another_process_agrees(certified, capsys, pair, policy):
    assert compared(certified, "honest", pair, policy)
    assert ", 0 of them different" in capsys.readouterr().out


@pytest.mark.parametrize("how", ["lifo", "pose", "mirrored", "renamed"])
def test_another_walk_or_another_answer_does_not(certified, capsys, how):
    assert not compared(certified, how, 0, "fifo")
    said = capsys.readouterr().out
    assert "309 transcripts and answers, " in said
    assert ", 0 of them different" not in said


@pytest.mark.slowest
def test_a_mirrored_explorer_has_the_same_sums_in_every_row(certified):
    """So sums cannot tell it from the real one, and transcripts can."""
    rows = [
        certified._rows(
            certified.check(name, edges=3, laws=("map", "pose", "bound")).uninterrupted().rows
        )
        for name in (f"exec:{sys.executable} {IMPOSTOR} mirrored fifo directional", "algorithm1")
    ]
    assert rows[0] == rows[1]
    assert not compared(certified, "mirrored", 0, "fifo")
