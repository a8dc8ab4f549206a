"""The comparison with the certified explorers can fail: other programs take their place."""

import importlib.util
import sys
from pathlib import Path

import pytest

IMPOSTOR = Path(__file__).parents[1] / "support" / "explorers_for_tests" / "impostor.py"


@pytest.fixture
def certified(proofs, monkeypatch):
    """The module ``certified.py``, loaded anew."""
    monkeypatch.syspath_prepend(str(proofs))
    specification = importlib.util.spec_from_file_location("certified", proofs / "certified.py")
    module = importlib.util.module_from_spec(specification)
    # Dataclasses look their module up.
    sys.modules["certified"] = module
    specification.loader.exec_module(module)
    yield module
    del sys.modules["certified"]


def compared(certified, how, pair, policy, edges=3):
    certified.EXPLORER = f"{sys.executable} {IMPOSTOR} {how}"
    return certified.transcripts_agree(certified.PAIRS[pair], policy, edges)


@pytest.mark.slow
@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest"])
@pytest.mark.parametrize("pair", [0, 1, 2])
def test_the_same_explorer_in_another_process_agrees(certified, capsys, pair, policy):
    assert compared(certified, "honest", pair, policy)
    assert ", 0 of them different" in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.parametrize("how", ["lifo", "pose", "mirrored", "renamed"])
def test_another_walk_or_another_answer_does_not(certified, capsys, how):
    assert not compared(certified, how, 0, "fifo")
    said = capsys.readouterr().out
    assert "309 transcripts and answers, " in said
    assert ", 0 of them different" not in said


@pytest.mark.slow
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


def test_of_a_program_that_has_no_worlds_to_walk_in_nothing_is_decided(certified):
    with pytest.raises(certified.NoVerdict, match="there is no run"):
        compared(certified, "honest", 2, "fifo", edges=-1)
