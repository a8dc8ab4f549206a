"""The certified checker and the certified folding: what they say, and that they can differ."""

import sys

import pytest

from proofs import test_certified_checker as quick
from proofs.test_certified_checker import impostor

checker = quick.checker
folding = quick.folding


@pytest.fixture
def built(checker):
    if not checker.CHECKER.exists():
        pytest.skip("not built: make -C proofs/coq explorer")
    return checker


def served(checker, name):
    return f"{sys.executable} {checker.SERVER} {name}"


def test_algorithm_1_behind_a_pipe_holds(built, capsys):
    assert built.judge_program(["--exec", served(built, "algorithm1"), "--edges", "2"]) == 0
    assert "HOLDS      right within paper in every world with at most 2 edges; 30 runs" in (
        capsys.readouterr().out
    )


@pytest.mark.parametrize(
    ("name", "lighthouse"),
    [("algorithm1-cluster", "cluster:single=true"), ("algorithm1-natural", "natural")],
)
def test_so_do_those_of_the_other_lighthouses(built, capsys, name, lighthouse):
    """In as many worlds as the package knows."""
    kind = lighthouse.partition(":")[0]
    arguments = ["--exec", served(built, name), "--edges", "2", "--lighthouse", kind]
    assert built.judge_program([*arguments, "--limit", "two-vertices"]) == 0
    runs = built.check(name, edges=2, lighthouse=lighthouse).uninterrupted().runs
    assert runs > 0
    assert f"with at most 2 edges; {runs} runs" in capsys.readouterr().out


def test_a_wrong_program_is_refuted_by_a_smallest_world(built, capsys):
    assert built.judge_program(["--exec", served(built, "no-retracing"), "--edges", "3"]) == 1
    said = capsys.readouterr().out
    assert said.startswith("REFUTED    no answer within the limit; 12 worlds with 3 edges, none")
    assert "sigma [0, 2, 3, 5, 1, 4] alpha [1, 0, 4, 5, 2, 3], start 0, place 0" in said


def test_a_limit_that_is_too_low_refutes(built, capsys):
    arguments = ["--exec", served(built, "algorithm1"), "--edges", "2"]
    assert built.judge_program([*arguments, "--limit", "2*m*n"]) == 0
    assert built.judge_program([*arguments, "--limit", "m"]) == 1
    assert "REFUTED    no answer within the limit" in capsys.readouterr().out


def test_a_program_that_remembers_the_last_run_is_no_function(built, capsys):
    assert built.judge_program(["--exec", served(built, "state-kept"), "--edges", "2"]) == 1
    assert capsys.readouterr().out.startswith("NO FUNCTION")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--exec", "no-such-program"], "no-such-program"),
        (["--exec", "true", "--limit", "D"], "--limit D: without a limit"),
        (["--exec", "true", "--limit", "none"], "--limit none: without a limit"),
        (["--exec", "true", "--limit", "n+"], "bound 'n+' is not one of"),
        (["--exec", "true", "--edges", "0"], "--edges 0: at least 1"),
        (["--exec", ""], "--exec '': a command expected"),
    ],
)
def test_bad_arguments_are_said_in_a_line(built, capfd, arguments, said):
    assert built.judge_program(arguments) == 2
    told = capfd.readouterr().err
    assert said in told
    assert "Traceback" not in told


@pytest.mark.slowest
def test_both_checkers_say_the_same_of_every_mutant(built):
    assert built.checkers_agree(2)


@pytest.mark.slowest
def test_other_explorers_than_those_that_are_named_are_noticed(built, capsys, monkeypatch):
    honest = built.served
    monkeypatch.setattr(built, "served", lambda _name, policy="fifo": honest("algorithm1", policy))
    assert not built.checkers_agree(2)
    assert "allworlds check Outcome(verdict='refuted'" in capsys.readouterr().out


LIES = {
    "all logs fold": lambda folded: {**folded, "folds": True},
    "the robot is elsewhere": lambda folded: {**folded, "here": folded["here"] + 1},
    "mirrored": lambda folded: {**folded, "sigma": folded["sigma"][::-1]},
}


@pytest.mark.slowest
def test_a_folding_that_says_the_same_agrees(folding, tmp_path, monkeypatch, capsys):
    impostor(folding, tmp_path, monkeypatch, lambda folded: folded)
    assert folding.foldings_agree(2)
    assert "; 0 folded otherwise" in capsys.readouterr().out


@pytest.mark.parametrize("lie", LIES)
def test_a_folding_that_lies_does_not(folding, tmp_path, monkeypatch, lie):
    impostor(folding, tmp_path, monkeypatch, LIES[lie])
    assert not folding.foldings_agree(2)


def test_the_extracted_folding_folds_to_the_world(folding):
    if not folding.FOLDING.exists():
        pytest.skip("not built: make -C proofs/coq explorer")
    assert folding.foldings_agree(2)
