"""The extracted checker reads strict JSON, and says in a line how each program has ended."""

import json
import sys
from pathlib import Path

import pytest

COQ = Path(__file__).parents[2] / "proofs" / "coq"
sys.path.insert(0, str(COQ))
try:
    from odd_program import ODD
finally:
    sys.path.remove(str(COQ))


@pytest.fixture
def lines(checkers):
    return checkers("certified_lines")


@pytest.fixture
def checker(checkers):
    return checkers("certified_checker")


def test_there_are_programs_of_each_kind():
    laws = [odd.laws for odd in ODD.values()]
    assert len(laws) > 100
    assert laws.count(("", "")) >= 20
    assert laws.count(("illegal-action", "illegal-action")) >= 40
    assert laws.count(("no-estimate", "no-estimate")) >= 14
    assert sum(one == "" and other != "" for one, other in laws) == 8


def written(odd):
    """Return the first line that the program writes."""
    move = odd.move if isinstance(odd.move, bytes) else odd.move.encode()
    return move.split(b"\n")[0]


def test_the_table_says_what_is_json_as_pythons_reader_does():
    """So the laws in the table are no opinion: only what a reader of JSON takes may be legal."""
    for name, odd in ODD.items():
        try:
            said = json.loads(written(odd))
        except (ValueError, RecursionError):
            said = None
        legal = isinstance(said, dict) and type(said.get("move", 0)) is int
        assert legal or odd.law == "illegal-action", name
        if odd.law == "" and odd.certified is None:
            assert legal, name


@pytest.mark.parametrize("verdict", ["holds", "no function"])
def test_a_checker_that_always_says_the_same_does_not_agree(lines, monkeypatch, capsys, verdict):
    monkeypatch.setattr(lines, "by_the_package", lambda name, _seconds: ODD[name].law)
    monkeypatch.setattr(lines, "asked", lambda *_arguments, **_options: {"verdict": verdict})
    assert not lines.lines_agree({name: ODD[name] for name in ("plain", "fraction")})
    assert "  fraction: ('illegal-action', " in capsys.readouterr().out
    assert not lines.lines_agree({})


def test_an_odd_program_that_there_is_not_is_bad_arguments(lines, monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["certified_lines.py", "even"])
    assert lines.main() == 2
    assert capsys.readouterr().err == "there is no odd program 'even'\n"


# ---- How a check ends ----


@pytest.mark.parametrize(
    ("does", "said"),
    [
        ("kill -SEGV $$", "the certified checker has ended with SIGSEGV: there is no verdict"),
        ("kill -KILL $$", "the certified checker has ended with SIGKILL: there is no verdict"),
        ("exit 0", "the certified checker has ended with code 0 and no verdict"),
        ("exit 3", "the certified checker has ended with code 3 and no verdict"),
        ("echo nonsense", "the certified checker has ended with code 0 and no verdict"),
        ("echo '[]'", "the certified checker has ended with code 0 and no verdict"),
        ('echo \'{"verdict": "so so"}\'', "has ended with code 0 and no verdict"),
        ('echo \'{"verdict": "holds"}\'; exit 1', "has ended with code 1 and no verdict"),
        ("echo 'checker: so it is' >&2; exit 2", "checker: so it is"),
    ],
)
def test_a_checker_that_ends_without_a_verdict_is_said_in_a_line(
    checker, monkeypatch, tmp_path, capfd, does, said
):
    impostor = tmp_path / "checker"
    impostor.write_text(f"#!/bin/sh\n{does}\n")
    impostor.chmod(0o755)
    monkeypatch.setattr(checker, "CHECKER", impostor)
    code = 2 if said.startswith("checker: ") else 3  # it has refused the question, or not decided
    assert checker.judge_program(["--exec", "true", "--edges", "1"]) == code
    told = capfd.readouterr()
    assert told.out == ""
    assert said in told.err
    assert told.err.count("\n") == 1


def test_a_checker_that_is_not_there_is_said_in_a_line(checker, monkeypatch, tmp_path, capfd):
    monkeypatch.setattr(checker, "CHECKER", tmp_path / "none")
    assert checker.judge_program(["--exec", "true", "--edges", "1"]) == 2
    assert "none: No such file or directory" in capfd.readouterr().err


# ---- Mutants of the reader ----
