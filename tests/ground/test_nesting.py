"""A check that another one causes ends at once, and says why; no process starts a second level."""

import importlib
import os
import shlex
import sys

import pytest

import allworlds
from allworlds.engines.single import subject_of
from allworlds.inputs.checks import InputError, NestedCheck
from allworlds.inputs.nesting import PLAYER, SAID
from allworlds.world.world import World

# Without the refusal it would go on: so that a test of this file does not, it counts.
CHECKS = """
import os, allworlds
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    return (yield from algorithm1(first))

def even(map_):
    return True

depth = int(os.environ.get("DEPTH", "0"))
assert depth < 2, "a second level"
os.environ["DEPTH"] = str(depth + 1)
"""
UNGUARDED = f"{CHECKS}\nallworlds.check(explore, edges=1)\n"
LINE = UNGUARDED.count("\n")
GUARDED = f'{CHECKS}\nif __name__ == "__main__":\n    allworlds.check(explore, edges=1)\n'
IN_ITS_BODY = """
import allworlds

def explore(first):
    allworlds.run("algorithm1", "k4")
    yield allworlds.Move(0)
"""
REMEDY = 'put it under if __name__ == "__main__":'


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("DEPTH", "0")
    (tmp_path / "unguarded.py").write_text(UNGUARDED)
    (tmp_path / "guarded.py").write_text(GUARDED)
    (tmp_path / "body.py").write_text(IN_ITS_BODY)
    (tmp_path / "helped.py").write_text("import unguarded\n")
    yield tmp_path
    for name in ("unguarded", "guarded"):
        sys.modules.pop(name, None)


VERBS = {
    "check": lambda: allworlds.check("algorithm1", edges=1),
    "run": lambda: allworlds.run("algorithm1", "k4"),
    "fuzz": lambda: allworlds.fuzz("algorithm1", edges=2, runs=1),
    "compare": lambda: allworlds.compare("algorithm1", edges=1),
    "a name": lambda: subject_of("algorithm1", None),
}


@pytest.mark.parametrize("verb", VERBS)
def test_a_player_begins_none(monkeypatch, verb):
    monkeypatch.setenv(PLAYER, "one")
    with pytest.raises(NestedCheck, match=f"', line .*, {SAID}, "):
        VERBS[verb]()


def test_what_plays_nothing_may_begin_anywhere(monkeypatch):
    monkeypatch.setenv(PLAYER, "one")
    assert allworlds.count(edges=1).exit_code == 0
    assert isinstance(next(iter(allworlds.worlds(edges=1))), World)


def test_a_file_that_is_loaded_for_a_check_begins_none(folder):
    (folder / "models.py").write_text(UNGUARDED.replace("explore, ", "'algorithm1', "))
    with pytest.raises(NestedCheck) as refused:
        allworlds.check("algorithm1", edges=1, where="models.py:even")
    place = f"'{folder / 'models.py'}', line {LINE}"
    assert str(refused.value) == f"{place}, {SAID}, as it is imported: {REMEDY}"
    os.environ["DEPTH"] = "0"
    assert allworlds.check("algorithm1", edges=1, where="guarded.py:even").exit_code == 0


@pytest.mark.processes
@pytest.mark.parametrize(
    ("words", "file", "remedy"),
    [
        ("check unguarded.py:explore --edges 1 --memory 2000", "unguarded.py", REMEDY),
        ("run unguarded.py k4", "unguarded.py", REMEDY),
        ("check shield:body.py:explore --edges 1", "body.py", "inside another one"),
        (f"check --edges 1 --exec '{sys.executable} helped.py'", "unguarded.py", REMEDY),
        (f"check --edges 1 --exec '{sys.executable} unguarded.py'", "unguarded.py", "inside"),
        (f"check --edges 1 --exec '{sys.executable} -m allworlds check'", "", "inside another one"),
    ],
)
def test_one_line_says_which_file_and_what_to_do(folder, cli, words, file, remedy):
    code, out, err = cli(*shlex.split(words))
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert err.startswith(f"allworlds: '{folder / file if file else ''}")
    assert f", {SAID}, " in err
    assert remedy in err


@pytest.mark.processes
@pytest.mark.usefixtures("folder")
def test_a_test_that_imports_such_a_file_hears_of_it():
    with pytest.raises(InputError, match=f"line {LINE}, {SAID}, as it is imported"):
        importlib.import_module("unguarded")


@pytest.mark.processes
@pytest.mark.usefixtures("folder")
def test_a_guard_is_the_remedy():
    assert allworlds.check("guarded.py:explore", edges=1).exit_code == 0
    assert os.environ["DEPTH"] == "0"
