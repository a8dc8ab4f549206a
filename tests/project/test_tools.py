"""The settings of the tools: what they name is there, and each number stands once."""

import re
import tomllib
from pathlib import Path

import pytest

import covered

ROOT = Path(__file__).parents[2]
SETTINGS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]


@pytest.mark.parametrize("named", SETTINGS["ruff"]["lint"]["per-file-ignores"])
def test_what_a_rule_is_not_for_is_there(named):
    assert any(ROOT.glob(named))


@pytest.mark.parametrize("runner", [".ci/run", "noxfile.py"])
def test_the_least_share_of_lines_is_no_number_of_a_runner(runner):
    text = (ROOT / runner).read_text(encoding="utf-8")
    assert f"{covered.LEAST:g}" not in text
    assert re.search(r"\bCOVERED\b", text)
