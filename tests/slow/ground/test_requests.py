"""A request is a value: frozen, checked where it is made, and the one home of a verb's options."""

import subprocess
import sys

import pytest


@pytest.mark.slowest
def test_mypy_knows_the_keywords(tmp_path):
    pytest.importorskip("mypy")
    calls = {
        'check("x", edgs=4)': 'Unexpected keyword argument "edgs" for "check"',
        'check("x", edges="4")': 'Argument "edges" to "check" has incompatible type "str"',
        "fuzz(runs=3)": 'Missing named argument "edges" for "fuzz"',
        'check("x", map_class="simple", shard=(0, 2), laws=["map"], bound=7)': None,
    }
    file = tmp_path / "calls.py"
    lines = ["import allworlds", *(f"allworlds.{call}" for call in calls)]
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    words = [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", str(file)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    for number, (call, said) in enumerate(calls.items(), start=2):
        errors = [each for each in done.stdout.splitlines() if f":{number}: error: " in each]
        assert any(said in each for each in errors) if said else not errors, (call, errors)
