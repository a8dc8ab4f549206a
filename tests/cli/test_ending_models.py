"""Tasks, predicates and lighthouses that end the process: its exit code is never theirs."""

import subprocess
import sys

import pytest

from models import PARITY
from processes import PATIENCE

CHECK = ["check", "--edges", "1", "--workers", "1"]

ENDS = {
    "task": "def judge(world, transcript, answer):\n    os._exit(0)\n",
    "where": "def few(map):\n    os._exit(0)\n",
    "lighthouse": PARITY.replace("yield cls(", "os._exit(0) or cls("),
}
"""For each kind of model one that ends the process when it is called."""

NAMES = {"task": "judge", "where": "few", "lighthouse": "Parity"}

SAYS = {
    "task": "def judge(world, transcript, answer):\n    return 'wrong'\n",
    "where": "def few(map):\n    return True\n",
}

AT_THE_END = "import atexit, os, sys\natexit.register({end})\n"


@pytest.fixture
def ended(tmp_path):
    """The exit code, stdout and stderr of the command with a model in a file."""

    def run(kind, text, *more):
        (tmp_path / "model.py").write_text(text)
        named = f"--{kind}", f"model.py:{NAMES[kind]}"
        done = subprocess.run(
            [sys.executable, "-m", "allworlds", *CHECK, *named, *more],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            check=False,
        )
        return done.returncode, done.stdout, done.stderr

    return run


@pytest.mark.parametrize("kind", ENDS)
def test_a_model_that_ends_the_process_is_bad_input(ended, kind):
    code, out, err = ended(kind, f"import os\n{ENDS[kind]}")
    assert (code, out) == (2, "")
    assert f"{kind} 'model.py:{NAMES[kind]}'" in err
    assert "os._exit(0) would end the process" in err
    assert err.count("\n") == 1, err


@pytest.mark.parametrize("kind", ENDS)
def test_a_model_that_becomes_another_program_is_bad_input(ended, kind):
    text = ENDS[kind].replace("os._exit(0)", "os.execv('/bin/true', ['true'])")
    code, out, err = ended(kind, f"import os\n{text}")
    assert (code, out) == (2, "")
    assert "os.execv('/bin/true') would end the process" in err
    assert err.count("\n") == 1, err


def test_a_model_that_ends_the_process_when_it_is_imported_is_bad_input(ended):
    code, out, err = ended("where", "from os import _exit\n_exit(0)\n")
    assert (code, out) == (2, "")
    assert err.startswith("allworlds: 'model.py' does not import: SystemExit: os._exit(0)")
    assert err.count("\n") == 1, err


@pytest.mark.parametrize(
    ("end", "kind", "more", "code"),
    [("os._exit, 0", "task", [], 1), ("sys.exit, 0", "task", ["-q"], 1)],
)
def test_the_exit_code_is_that_of_the_verdict_whatever_a_model_does_at_the_end(
    ended, end, kind, more, code
):
    found, out, err = ended(kind, AT_THE_END.format(end=end) + SAYS[kind], *more)
    assert found == code, err
    assert ("refuted" if code else "holds") in out.lower()
