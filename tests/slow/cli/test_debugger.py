"""``run --step N --pdb``: the debugger stops in the explorer where it begins to choose a step."""

import io
import re

import pytest

STAR = """\
from allworlds import Checkpoint, CombinatorialMap, Estimate, Move


def explore(first):
    k = first.degree
    sigma, alpha = [*range(1, k), 0], [*range(k)]
    for door in range(k):
        yield Move(1 if door else 0)
        yield Move(0)
        alpha[door] = len(sigma)
        sigma.append(len(sigma))
        alpha.append(door)
        yield Checkpoint(sigma, alpha, here=door)
    return Estimate(CombinatorialMap(sigma, alpha), here=k - 1)
"""


@pytest.fixture
def debugged(cli, monkeypatch, tmp_path):
    """Runs the explorer in the theta world with these commands to the debugger."""
    (tmp_path / "star.py").write_text(STAR)
    monkeypatch.chdir(tmp_path)

    def run(*arguments, typed):
        monkeypatch.setattr("sys.stdin", io.StringIO("".join(f"{line}\n" for line in typed)))
        return cli("run", "star.py", "theta", "--pdb", *arguments)

    return run


@pytest.mark.parametrize(
    ("step", "line", "door"),
    [(1, 5, "*** NameError"), (2, 9, "0"), (3, 10, "0"), (4, 9, "1"), (7, 10, "2")],
)
def test_it_stops_where_the_explorer_begins_to_choose_that_step(debugged, step, line, door):
    code, out, _ = debugged("--step", str(step), typed=["p door", "c"])
    report, _, session = out.partition("\n> ")
    assert code == 1
    assert "law map is broken" in report
    assert f"star.py({line})explore()" in session.splitlines()[0]
    assert f"(Pdb) {door}" in session


def test_from_there_one_goes_on_line_by_line_and_through_checkpoints(debugged):
    _, out, _ = debugged("--step", "3", typed=["n", "n", "n", "n", "n", "p door", "c"])
    lines = [int(line) for line in re.findall(r"> \S*star\.py\((\d+)\)explore", out)]
    assert lines == [10, 11, 12, 13, 7, 8]
    assert "(Pdb) 1" in out


@pytest.mark.parametrize("typed", [["q"], ["door = None", "c"], []], ids=["q", "set", "end"])
def test_the_report_and_the_exit_code_are_those_of_the_run(debugged, cli, typed):
    code, report, _ = cli("run", "star.py", "theta")
    debugged_code, out, _ = debugged("--step", "2", typed=typed)
    assert debugged_code == code
    assert out.startswith(report)
    assert "star.py(9)explore()" in out[len(report) :]


def test_a_step_that_the_run_does_not_have_is_refused(debugged):
    for step in ("0", "8"):
        code, out, err = debugged("--step", step, typed=[])
        assert (code, out) == (2, "")
        assert err == f"allworlds: --step {step} is not from 1 to 7, where this run ends\n"


INNER = STAR.replace(
    "        yield Move(1 if door else 0)\n        yield Move(0)\n",
    "        yield from _go(door)\n",
).replace(
    "\n\ndef explore",
    "\n\ndef _go(way):\n    yield Move(1 if way else 0)\n    yield Move(0)\n\n\ndef explore",
)


def test_it_stops_in_the_innermost_generator_that_waits(debugged, tmp_path):
    (tmp_path / "star.py").write_text(INNER)
    _, out, _ = debugged("--step", "4", typed=["p way", "up", "p door", "c"])
    session = out.partition("\n> ")[2]
    assert "_go()" in session.splitlines()[0]
    assert next(line for line in session.splitlines() if line.startswith("(Pdb) ")) == "(Pdb) 1"
