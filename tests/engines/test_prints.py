"""Output of an explorer in the run that is told: ``run`` shows it, and findings keep it."""

import json
import sys

import pytest

from allworlds import Estimate, check, run
from allworlds.engines.prints import KEPT, Prints
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.reports.content.single_run import printed
from allworlds.reports.parts import Quote
from native_libraries import attack

pytestmark = pytest.mark.processes

EXPLORERS = """
import os, sys
from allworlds import Estimate
from allworlds.explorers.builtin.algorithm1 import algorithm1

print("loaded")

def right(first):
    print("begins with", first.degree)
    print("to stderr", file=sys.stderr)
    os.write(1, b"raw \\x1b[31m\\n")
    return (yield from algorithm1(first))

def wrong(first):
    print("begins with", first.degree)
    estimate = yield from algorithm1(first)
    print("ends")
    return Estimate(estimate.map, estimate.map.sigma[estimate.here])

def dies(first):
    print("last words")
    os._exit(3)
    yield

def talks(first):
    for i in range(3000):
        print("line", i)
    return (yield from algorithm1(first))
"""


@pytest.fixture
def named(tmp_path):
    file = tmp_path / "printing.py"
    file.write_text(EXPLORERS, encoding="utf-8")
    return lambda name: f"{file}:{name}"


def test_run_shows_each_line_once_with_control_characters_escaped(named):
    told = run(named("right"), "theta")
    assert told.outcome.output == "begins with 3\nto stderr\nraw \\x1b[31m\n"
    assert told.to_json()["output"] == told.outcome.output


def test_on_the_command_line_lines_have_a_prefix_and_stdout_is_clean_for_json(named, cli):
    code, out, err = cli("run", named("right"), "theta")
    assert code == 0
    lines = [line for line in out.splitlines() if line.startswith("| ")]
    assert lines == ["| begins with 3", "| to stderr", "| raw \\x1b[31m"]
    assert "begins with" not in err
    code, out, err = cli("run", named("right"), "theta", "--json")
    assert json.loads(out)["output"].startswith("begins with 3\n")
    assert "begins with" not in err


def test_a_run_that_prints_nothing_has_no_such_key():
    assert "output" not in run("algorithm1", "theta").to_json()


def test_of_much_the_beginning_and_the_end_are_kept(named):
    output = run(named("talks"), "theta").outcome.output
    assert output.startswith("line 0\nline 1\n")
    assert output.endswith("line 2998\nline 2999\n")
    assert KEPT - 64 < len(output.encode()) <= KEPT


def closure():
    def explore(first):
        print("begins with", first.degree)  # noqa: T201  # prints are what is tested
        print("to stderr", file=sys.stderr)  # noqa: T201
        sys.stdout.buffer.write(b"raw \x1b[31m\n")
        estimate = yield from algorithm1(first)
        return Estimate(estimate.map, estimate.map.sigma[estimate.here])

    return explore


def test_of_an_explorer_in_this_process_the_run_that_is_told_alone_is_heard(capfd):
    told = run(closure(), "theta")
    assert told.outcome.output == "begins with 3\nto stderr\nraw \\x1b[31m\n"
    (finding,) = check(closure(), edges=3).findings
    degree = finding.transcript.first.degree
    assert finding.output == f"begins with {degree}\nto stderr\nraw \\x1b[31m\n"
    assert "begins with" not in "".join(capfd.readouterr())


def test_what_a_library_prints_is_kept_although_its_process_is_ended():
    library = attack('int puts(const char *); puts("from the library")')
    told = run(f"native:{library}", "edge")
    assert "from the library\n" in told.outcome.output


def test_what_is_told_in_the_traceback_is_not_told_again():
    (quote,) = printed("a\nb\n")
    assert quote == Quote("output", "printed by the explorer", "a\nb\n", prefix="| ")
    assert printed("a\n", "stderr:\na\n") == []
    assert printed("") == []


def text_of(*printed):
    prints = Prints()
    for part in printed:
        prints.add(part)
    return prints.text


def test_the_limit_is_that_of_the_escaped_text():
    assert text_of(b"a" * KEPT) == "a" * KEPT
    for letter in (b"\x1b", b"a", "\u00e9".encode(), "\u200b".encode(), b"\xff"):
        for count in (KEPT // 4, KEPT // 4 + 1, KEPT, KEPT + 1, 5 * KEPT):
            printed = letter * count
            text = text_of(printed[: KEPT // 3], printed[KEPT // 3 :])
            assert len(text.encode()) <= KEPT
            before, cut, after = text.partition("\n[... ")
            if cut:
                lost, _, after = after.partition(" bytes more ...]\n")
                shown = {b"\x1b": 4, b"\xff": 4, "\u200b".encode(): 2}.get(letter, 1)
                kept = (len(before.encode()) + len(after.encode())) // shown
                assert int(lost) == len(printed) - kept
                assert len(before) > KEPT // 6
                assert len(after) > KEPT // 6


def test_what_a_program_writes_to_stderr_is_kept(tmp_path):
    file = tmp_path / "program.sh"
    answer = '{"estimate": {"sigma": [0, 1], "alpha": [1, 0], "here": 7}}'
    file.write_text(f"while read line; do echo hears >&2; echo '{answer}'; done\n")
    (finding,) = check(f"exec:sh {file}", edges=1).findings
    assert finding.output == "hears\n"
