"""A signal that interrupts, at any moment: it never makes a finding or another wrong verdict."""

import json
import os
import random
import shlex
import signal
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

import signalled
from processes import PATIENCE
from small import slowest

SUPPORT = Path(signalled.__file__).parent
WRONG = SUPPORT / "explorers_for_tests" / "wrong.py"
PROGRAM = WRONG.with_name("program.py")
MODELS = """
def even(map_):
    return all(degree % 2 == 0 for degree in map_.degrees)
"""
COMMANDS = {
    "built in": ("check algorithm1 --engine python --edges 2", "play_run"),
    "either engine": ("check algorithm1 --edges 2", "turn"),
    "one's own": (f"check {WRONG}:right --edges 2", "heard"),
    "models": (f"check {WRONG}:right --edges 2 --workers 2 --where models.py:even", "attempted"),
    "program": (f"check --edges 1 --exec '{sys.executable} {PROGRAM} right'", "heard"),
    "wrong": (f"check {WRONG}:everywhere --edges 1", "count_outcome"),
}
"""Commands, and of each a function that is called where it is at work."""

STAGES = (signalled.HEEDS, "call", "gather", "emit")
"""Functions that every command calls, in this order."""


def draw(seed):
    """A command; the signal; the function from whose first call on calls are counted, and so on."""
    drawn = random.Random(seed)
    name = drawn.choice(["built in", *COMMANDS])  # its explorer plays in the first process
    number = drawn.choice([signal.SIGTERM, signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
    begin = drawn.choice([*STAGES, *[COMMANDS[name][1]] * 4])
    return name, number, begin, int(10 ** drawn.uniform(0, 4)), drawn.random() < 0.7, seed % 3 == 2


def ran(folder, name, *words, drawn=None):
    """The exit code and the document of a command."""
    program = ["-m", "allworlds"] if drawn is None else [SUPPORT / "signalled.py", *drawn]
    done = subprocess.run(
        [
            sys.executable,
            *map(str, program),
            *shlex.split(COMMANDS[name][0]),
            "--json",
            *map(str, words),
        ],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        start_new_session=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
    )
    document = json.loads(done.stdout) if done.stdout else {}
    document.pop("made_by", None)
    return done.returncode, document, done.stderr


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("undisturbed")
    (folder / "models.py").write_text(MODELS)
    return cache(lambda name: ran(folder, name)[:2])


@pytest.mark.processes
@pytest.mark.parametrize("seed", [*range(12, 17), *map(slowest, range(17, 24))])
def test_a_signal_at_any_moment_interrupts_or_changes_nothing(undisturbed, tmp_path, seed):
    (tmp_path / "models.py").write_text(MODELS)
    name, number, *moment = draw(seed)
    right, run = undisturbed(name), ("--run", "kept") if seed % 2 else ()
    drawn = [int(number), *moment[:2], *map(int, moment[2:])]
    code, document, told = ran(tmp_path, name, *run, drawn=drawn)
    assert code == 130 or (code, document) == right, told
    assert "Traceback" not in told
    if code == 130:
        assert not document or document["exit_code"] == 130
        assert not document.get("findings") or name == "wrong"
    if run:
        assert ran(tmp_path, name, *run)[:2] == right


@pytest.mark.processes
def test_a_terminal_that_is_closed_interrupts(tmp_path):
    ours, theirs = os.openpty()

    def begin():
        signalled.heed_all()
        os.login_tty(theirs)

    words = "check algorithm1 --engine python --edges 7 --workers 1 -o report.json"
    process = subprocess.Popen(
        [sys.executable, "-m", "allworlds", *words.split()],
        cwd=tmp_path,
        preexec_fn=begin,  # noqa: PLW1509  # it starts no thread
    )
    os.close(theirs)
    shown = b""
    while b"edges 3" not in shown:  # the bar of a level
        shown += os.read(ours, 1 << 10)
    os.close(ours)
    assert process.wait(PATIENCE) == 130
    assert json.loads((tmp_path / "report.json").read_text())["exit_code"] == 130
