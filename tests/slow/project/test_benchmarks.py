"""The program that measures the engines runs, and says what is wrong with a peer."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]


@pytest.mark.usefixtures("compiled")
def test_the_program_that_measures_sets_others_beside_the_engines():
    line = [sys.executable, ROOT / "benchmarks/rounds.py", "--edges=4", "--rounds=1"]
    told = subprocess.run([*line, "--peer=a@3=true"], check=True, capture_output=True).stdout
    document = json.loads(told)
    names = [row["name"] for row in document["contenders"]]
    assert names == ["kernel", "kernel-2", "count", "judge", "python", "a"]
    assert document["contenders"][-1]["worlds"] == 74  # OEIS A000698
    assert [row["to"] for row in document["ratios"]] == names[1:]
    failed = subprocess.run([*line, "--peer=culprit=false"], check=False, capture_output=True)
    assert b"'culprit'" in failed.stderr
