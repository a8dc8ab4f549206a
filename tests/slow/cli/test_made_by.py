"""Under ``made_by`` stands all that differs from run to run, and nothing else does."""

import functools
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from cli import test_made_by as quick
from cli.test_made_by import NAMES, takes_workers
from printed import without_made_by
from recorded.record import least
from small import slowest

pytestmark = pytest.mark.slowest

tmp = quick.tmp

TEAMS = Path(__file__).parents[2] / "support" / "teams.py"
PAPER = Path(__file__).parents[3] / "papers" / "minimal_information"


# What takes a number of workers, with more to do than one of them does at a time.
WORKING = {
    "check": "check allworlds.corpus.explorers:pose_lost --edges 3 --max-findings 3",
    "check, compiled": "check --engine kernel --edges 4",
    "fuzz": "fuzz allworlds.corpus.explorers:pose_lost --edges 8 --runs 130",
    "worst": "worst --edges 4",
    "compare": "compare algorithm1 folding --edges 3",
    "team": f"team {TEAMS}:waits {TEAMS}:searches --model meeting:apart=false --edges 3",
    "ledger": f"ledger {PAPER} --only fig1 --only cycles",
}


# Runs commands in one process, and prints a line for each: its exit code and its document.
DRIVER = """
import contextlib, io, json, sys
from allworlds.cli.app import call
for words in json.loads(sys.stdin.read()):
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        code = call([*words, "--json"])
    print(json.dumps([code, out.getvalue()]))
"""


@functools.cache
def told(seed, commands):
    """For each command its exit code and its document, in a process with that hash seed."""
    done = subprocess.run(
        [sys.executable, "-c", DRIVER],
        input=json.dumps(commands),
        env={**os.environ, "PYTHONHASHSEED": str(seed)},
        capture_output=True,
        text=True,
        check=True,
    )
    return [json.loads(line) for line in done.stdout.splitlines()]


@pytest.mark.slowest
def test_no_document_depends_on_the_order_of_hashes(tmp):
    # init refuses to do twice what it has done.
    names = [name for name in NAMES if name != "init"]
    commands = tuple(tuple(least(name, tmp)) for name in names)
    one, other = (told(seed, commands) for seed in (1, 2))
    assert len(one) == len(commands)
    for words, (code, text), (code_2, text_2) in zip(commands, one, other, strict=True):
        assert (code, without_made_by(text)) == (code_2, without_made_by(text_2)), words


@pytest.mark.parametrize("half", [0, slowest(1)])
def test_no_document_depends_on_the_number_of_workers(half, tmp):
    assert {name.partition(",")[0] for name in WORKING} == {
        name for name in NAMES if takes_workers(name)
    }
    commands = [words.format(tmp=tmp).split() for words in [*WORKING.values()][half::2]]

    def with_workers(count):
        return tuple((*words, "--workers", str(count)) for words in commands)

    one, two = (told(count, with_workers(count)) for count in (1, 2))
    for words, (code, text), (code_2, text_2) in zip(commands, one, two, strict=True):
        assert (code, without_made_by(text)) == (code_2, without_made_by(text_2)), words
