"""Under ``made_by`` stands all that differs from run to run, and nothing else does."""

import functools
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from allworlds import __version__
from allworlds.cli.app import call
from allworlds.verbs import VERBS
from printed import without_made_by
from recorded.record import least
from small import long

PAPER = Path(__file__).parents[2] / "papers" / "minimal_information"
NAMES = [verb.name for verb in VERBS]
# What takes a number of workers, with more to do than one of them does at a time.
WORKING = {
    "check": "check allworlds.corpus.explorers:pose_lost --edges 3 --max-findings 3",
    "check, compiled": "check --engine kernel --edges 4",
    "fuzz": "fuzz allworlds.corpus.explorers:pose_lost --edges 8 --runs 130",
    "worst": "worst --edges 4",
    "compare": "compare algorithm1 folding --edges 3",
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


@pytest.fixture(scope="module")
def tmp(tmp_path_factory):
    return str(tmp_path_factory.mktemp("made-by"))


@pytest.mark.slow
def test_no_document_depends_on_the_order_of_hashes(tmp):
    # init refuses to do twice what it has done.
    names = [name for name in NAMES if name != "init"]
    commands = tuple(tuple(least(name, tmp)) for name in names)
    one, other = (told(seed, commands) for seed in (1, 2))
    assert len(one) == len(commands)
    for words, (code, text), (code_2, text_2) in zip(commands, one, other, strict=True):
        assert (code, without_made_by(text)) == (code_2, without_made_by(text_2)), words


@pytest.mark.slow
@pytest.mark.parametrize("half", [0, long(1)])
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


def takes_workers(name):

    from allworlds.cli.app import command_line

    command = command_line()
    for word in name.split():
        command = command.commands[word]
    return any("--workers" in param.opts for param in command.params)


@pytest.mark.no_cover
@pytest.mark.parametrize("name", NAMES)
def test_every_document_says_who_made_it(name, tmp, capsys):
    words = [*least(name, tmp), "--json"]
    workers = ["--workers", "2"] if takes_workers(name) else []
    call([*words, *workers])
    document = json.loads(capsys.readouterr().out)
    keys = [*document]
    assert (keys[0], keys[-1]) == ("schema", "made_by")
    made_by = document["made_by"]
    assert made_by["version"] == __version__
    assert made_by["command"] == [*words, *workers]
    assert made_by["workers"] == (2 if workers else None)
    assert made_by["host"]["cores"] == os.cpu_count()
    assert made_by["host"]["python"] == ".".join(map(str, sys.version_info[:3]))
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", made_by["started"])
    assert made_by["seconds"] >= 0


def test_a_search_tells_the_seconds_of_its_levels(tmp, capsys):
    words = least("ambiguity search", tmp)
    assert call([*words, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert len(document["made_by"]["level_seconds"]) == len(document["levels"]) > 0
    assert "seconds" not in document["levels"][0]


def test_the_number_of_workers_is_told_as_a_number(capsys):
    assert call(["worst", "--edges", "1", "--workers", "auto", "--json"]) == 0
    made_by = json.loads(capsys.readouterr().out)["made_by"]
    assert made_by["workers"] == len(os.sched_getaffinity(0))
    assert made_by["command"][-2:] == ["auto", "--json"]


def test_in_python_a_document_does_not_say_who_made_it():
    import allworlds

    assert "made_by" not in allworlds.count(edges=1).to_json()
