"""The comparison with the certified explorers can fail: other programs take their place."""

import importlib.util
import sys
from functools import partial
from pathlib import Path

import pytest

COQ = Path(__file__).parents[2] / "proofs" / "coq"
IMPOSTOR = Path(__file__).parents[1] / "support" / "explorers_for_tests" / "impostor.py"


@pytest.fixture
def certified(monkeypatch):
    """The module ``certified_programs.py``, loaded anew."""
    monkeypatch.syspath_prepend(str(COQ))
    specification = importlib.util.spec_from_file_location(
        "certified_programs", COQ / "certified_programs.py"
    )
    module = importlib.util.module_from_spec(specification)
    # Dataclasses look their module up.
    sys.modules["certified_programs"] = module
    specification.loader.exec_module(module)
    yield module
    del sys.modules["certified_programs"]


def compared(certified, how, pair, policy, edges=3):
    certified.EXPLORER = f"{sys.executable} {IMPOSTOR} {how}"
    return certified.transcripts_agree(certified.PAIRS[pair], policy, edges)


def test_of_a_program_that_has_no_worlds_to_walk_in_nothing_is_decided(certified, checkers):
    with pytest.raises(checkers("certificate_file").NoVerdict, match="there is no run"):
        compared(certified, "honest", 2, "fifo", edges=-1)


@pytest.mark.parametrize("how", ["leaves", "is-killed"])
def test_a_program_that_is_lost_is_not_one_that_differs(certified, capsys, how, tmp_path):
    program = tmp_path / "lost"
    program.write_text(f"#!/bin/sh\nread line\n{'exit 3' if how == 'leaves' else 'kill -9 $$'}\n")
    program.chmod(0o755)
    certified.EXPLORER = program
    compared = partial(certified.transcripts_agree, certified.PAIRS[0], "fifo", 1)
    assert certified.outcome(compared) == 3
    said = capsys.readouterr().out
    assert "could not be decided: the certified explorer: crash: the end of its process" in said
    certified.JUDGE = program
    assert certified.outcome(partial(certified.judges_agree, 1)) == 3
    assert "could not be decided: lost: 0 answers to " in capsys.readouterr().out
