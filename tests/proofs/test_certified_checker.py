"""The certified checker and the certified folding: what they say, and that they can differ."""

import json
import sys

import pytest

from allworlds.document.struct import replace
from allworlds.outcome import Stopped
from allworlds.studies.check.exhaustive import check


@pytest.fixture
def checker(checkers):
    return checkers("certified_checker")


@pytest.fixture
def folding(checkers):
    return checkers("certified_folding")


@pytest.fixture
def built(checker):
    if not checker.CHECKER.exists():
        pytest.skip("not built: make -C proofs/coq explorer")
    return checker


def served(checker, name):
    return f"{sys.executable} {checker.SERVER} {name}"


# ---- The verdict on a program ----


@pytest.mark.slow
def test_algorithm_1_behind_a_pipe_holds(built, capsys):
    assert built.judge_program(["--exec", served(built, "algorithm1"), "--edges", "2"]) == 0
    assert "HOLDS      right within paper in every world with at most 2 edges; 30 runs" in (
        capsys.readouterr().out
    )


@pytest.mark.slow
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


@pytest.mark.slow
def test_a_wrong_program_is_refuted_by_a_smallest_world(built, capsys):
    assert built.judge_program(["--exec", served(built, "no-retracing"), "--edges", "3"]) == 1
    said = capsys.readouterr().out
    assert said.startswith("REFUTED    no answer within the limit; 12 worlds with 3 edges, none")
    assert "sigma [0, 2, 3, 5, 1, 4] alpha [1, 0, 4, 5, 2, 3], start 0, place 0" in said


@pytest.mark.parametrize(
    ("world", "said"),
    [
        ({"finding": "pose"}, "REFUTED    pose; 1 world with 1 edge"),
        ({"finding": "map", "fault": "crash", "how": "gone"}, "REFUTED    crash: gone; 1 world"),
    ],
)
def test_the_law_that_is_broken_is_said_first(checker, world, said):
    refuted = {"sigma": [0, 1], "alpha": [1, 0], "place": 0, **world}
    answer = {"verdict": "refuted", "edges": 1, "runs": 3, "refutations": [refuted]}
    assert checker.told(answer, "paper")[0].startswith(said)


@pytest.mark.slow
def test_a_limit_that_is_too_low_refutes(built, capsys):
    arguments = ["--exec", served(built, "algorithm1"), "--edges", "2"]
    assert built.judge_program([*arguments, "--limit", "2*m*n"]) == 0
    assert built.judge_program([*arguments, "--limit", "m"]) == 1
    assert "REFUTED    no answer within the limit" in capsys.readouterr().out


@pytest.mark.slow
def test_a_program_that_remembers_the_last_run_is_no_function(built, capsys):
    assert built.judge_program(["--exec", served(built, "state-kept"), "--edges", "2"]) == 1
    assert capsys.readouterr().out.startswith("NO FUNCTION")


@pytest.mark.slow
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


# ---- Compared with the package's ----


def test_a_comparison_that_cannot_be_made_is_not_one_that_differs(checker, capsys):
    def broken():
        raise checker.NoVerdict("the judge has ended with SIGKILL")

    for comparisons, code, word in (
        ([lambda: True], 0, "AGREE"),
        ([lambda: True, broken], 3, "UNDECIDED"),
        ([broken, lambda: True], 3, "UNDECIDED"),
        ([broken, lambda: False], 1, "DISAGREE"),
        ([lambda: False, broken], 1, "DISAGREE"),
    ):
        assert checker.outcome(*comparisons) == code
        said = capsys.readouterr()
        assert said.out == f"{word}\n"
        assert ("SIGKILL" in said.err) == (broken in comparisons)


def test_a_check_that_has_not_been_finished_is_no_outcome(checker, monkeypatch):
    (mutant,) = (m for m in checker.WRONG_EXPLORERS if m.name == "mirror-image")
    stopped = replace(check(mutant.explorer(), edges=1), ending=Stopped("the time limit"))
    monkeypatch.setattr(checker, "check", lambda *_, **__: stopped)
    with pytest.raises(checker.NoVerdict, match="inconclusive"):
        checker.package_outcome(mutant, 1)


@pytest.mark.slow
@pytest.mark.long
def test_both_checkers_say_the_same_of_every_mutant(built):
    assert built.checkers_agree(2)


@pytest.mark.slow
@pytest.mark.long
def test_other_explorers_than_those_that_are_named_are_noticed(built, capsys, monkeypatch):
    honest = built.served
    monkeypatch.setattr(built, "served", lambda _name, policy="fifo": honest("algorithm1", policy))
    assert not built.checkers_agree(2)
    assert "allworlds check Outcome(verdict='refuted'" in capsys.readouterr().out


def impostor(folding, tmp_path, monkeypatch, lie):
    """The package's own folding in the place of the extracted one, but for a lie."""
    program = tmp_path / "folding"
    monkeypatch.setattr(folding, "FOLDING", program)
    answers = {
        folding.line_of(log): lie(folding.folded_by_judge(log)) for _, _, log in folding.logs(2)
    }
    told = tmp_path / "answers.json"
    told.write_text(json.dumps(answers))
    program.write_text(
        f"#!{sys.executable}\nimport json, sys\nanswers = json.load(open({str(told)!r}))\n"
        "for line in sys.stdin: print(json.dumps(answers[line.strip()]))\n"
    )
    program.chmod(0o755)


LIES = {
    "all logs fold": lambda folded: {**folded, "folds": True},
    "the robot is elsewhere": lambda folded: {**folded, "here": folded["here"] + 1},
    "mirrored": lambda folded: {**folded, "sigma": folded["sigma"][::-1]},
}


@pytest.mark.slow
def test_a_folding_that_says_the_same_agrees(folding, tmp_path, monkeypatch, capsys):
    impostor(folding, tmp_path, monkeypatch, lambda folded: folded)
    assert folding.foldings_agree(2)
    assert "; 0 folded otherwise" in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.parametrize("lie", LIES)
def test_a_folding_that_lies_does_not(folding, tmp_path, monkeypatch, lie):
    impostor(folding, tmp_path, monkeypatch, LIES[lie])
    assert not folding.foldings_agree(2)


@pytest.mark.no_cover
def test_the_compiled_judge_is_asked_too(folding, tmp_path, monkeypatch):
    impostor(folding, tmp_path, monkeypatch, lambda folded: folded)
    monkeypatch.setattr(folding, "folds_compiled", lambda _world, _log: True)
    assert not folding.foldings_agree(2)


@pytest.mark.slow
def test_the_extracted_folding_folds_to_the_world(folding):
    if not folding.FOLDING.exists():
        pytest.skip("not built: make -C proofs/coq explorer")
    assert folding.foldings_agree(2)
