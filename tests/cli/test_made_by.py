"""Under ``made_by`` stands all that differs from run to run, and nothing else does."""

import json
import os
import re
import sys

import pytest

from allworlds import __version__
from allworlds.cli.app import call
from allworlds.verbs import VERBS
from recorded.record import least

pytestmark = pytest.mark.usefixtures("compiled")  # for worst

NAMES = [verb.name for verb in VERBS]


@pytest.fixture(scope="module")
def tmp(tmp_path_factory):
    return str(tmp_path_factory.mktemp("made-by"))


def takes_workers(name):

    from allworlds.cli.app import command_line

    command = command_line()
    for word in name.split():
        command = command.commands[word]
    return any("--workers" in param.opts for param in command.params)


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
