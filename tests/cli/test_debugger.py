"""The debugger stops in the explorer where it begins to choose a step."""

import io
import re
import signal
import sys

import pytest

import allworlds
from allworlds.cli.run import debug, ensure_step
from allworlds.inputs.checks import InputError

LEAVES = """\
from allworlds import CombinatorialMap, Estimate, Move


def explore(first):
    step = "one"
    yield Move(0)
    step = "two"
    yield Move(0)
    step = "three"
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
"""


@pytest.fixture(autouse=True)
def interrupts_as_before():
    """Give interrupts back to who had them: from ``c`` on the debugger takes them."""
    before = signal.getsignal(signal.SIGINT)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def file(tmp_path, monkeypatch):
    (tmp_path / "leaves.py").write_text(LEAVES)
    monkeypatch.chdir(tmp_path)
    return "leaves.py:explore"


@pytest.mark.parametrize("step", [0, 4])
def test_a_step_that_the_run_does_not_have_is_refused(file, step):
    run = allworlds.run(file, "edge")
    for legal in (1, 2, 3):
        ensure_step(run, legal)
    with pytest.raises(
        InputError, match=rf"^--step {step} is not from 1 to 3, where this run ends$"
    ):
        ensure_step(run, step)


@pytest.mark.parametrize(("step", "word"), [(2, "one"), (3, "two")])
def test_it_stops_where_the_explorer_begins_to_choose_that_step(
    file, step, word, monkeypatch, capsys
):
    run = allworlds.run(file, "edge")
    monkeypatch.setattr(sys, "stdin", io.StringIO("p step\nr\nn\n"))
    debug(run, step)
    assert sys.gettrace() is None
    assert f"(Pdb) '{word}'" in capsys.readouterr().out


def test_the_report_goes_before_the_debugger(file, monkeypatch, cli):
    report = cli("run", file, "edge")
    monkeypatch.setattr(sys, "stdin", io.StringIO("p step\nc\n"))
    code, out, err = cli("run", file, "edge", "--pdb", "--step", "3")
    assert (code, err) == (report[0], report[2])
    assert out.startswith(report[1])
    assert "(Pdb) 'two'" in out[len(report[1]) :]
    refused = cli("run", file, "edge", "--pdb", "--step", "4")
    assert refused == (2, "", "allworlds: --step 4 is not from 1 to 3, where this run ends\n")


TELLS = """\
from allworlds import Checkpoint, CombinatorialMap, Estimate, Move
from allworlds.explorers.builtin.algorithm1 import algorithm1


def leaves():
    step = "one"
    yield Move(0)
    yield Checkpoint((0, 1), (1, 0), 1)
    yield Checkpoint((0, 1), (1, 0), 1)
    step = "two"
    yield Move(0)
    yield Checkpoint((0, 1), (1, 0), 0)


def explore(first):
    step = "none"
    yield from leaves()
    step = "three"
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)


def behind(first, *, choices):
    step = "before"
    found = yield from algorithm1(first, choices=choices)
    step = "after"
    return found
"""


@pytest.mark.parametrize(
    ("name", "step", "seen"),
    [
        ("explore", 1, "16 step 17 18 none"),
        ("explore", 2, "8 one 9 10 one"),
        ("behind", 1, "23 step 24 25 before"),
        ("behind", 2, "25 before 26"),
    ],
)
def test_it_stops_once_and_goes_on_line_by_line_from_there(
    name, step, seen, tmp_path, monkeypatch, capsys
):
    (tmp_path / "tells.py").write_text(TELLS)
    monkeypatch.chdir(tmp_path)
    run = allworlds.run(f"tells.py:{name}", "edge")
    monkeypatch.setattr(sys, "stdin", io.StringIO("p step\nn\nn\np step\nc\n"))
    debug(run, step)
    out = capsys.readouterr().out
    stops = re.findall(r"> .*tells\.py\((\d+)\)|'(\w+)'", out)
    assert [line or said for line, said in stops] == seen.split()
