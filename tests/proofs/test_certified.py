"""The comparison with the certified explorers can fail: other programs take their place."""

import importlib.util
import sys
from pathlib import Path

import pytest

IMPOSTOR = Path(__file__).parents[1] / "support" / "explorers_for_tests" / "impostor.py"


@pytest.fixture
def certified(proofs, monkeypatch):
    """The module ``certified_programs.py``, loaded anew."""
    monkeypatch.syspath_prepend(str(proofs))
    specification = importlib.util.spec_from_file_location(
        "certified_programs", proofs / "certified_programs.py"
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


def test_of_a_program_that_has_no_worlds_to_walk_in_nothing_is_decided(certified):
    with pytest.raises(certified.NoVerdict, match="there is no run"):
        compared(certified, "honest", 2, "fifo", edges=-1)
