"""The certified checker and the certified folding: what they say, and that they can differ."""

import json
import sys

import pytest

from allworlds.documents.document import replace
from allworlds.outcome import Stopped
from allworlds.studies.check.exhaustive import check


@pytest.fixture
def checker(checkers):
    return checkers("certified_checker")


@pytest.fixture
def folding(checkers):
    return checkers("certified_folding")


# ---- The verdict on a program ----


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
        *reasons, last = capsys.readouterr().out.splitlines()
        assert last == word
        why = "could not be decided: the judge has ended with SIGKILL"
        assert reasons == [why] * comparisons.count(broken)


def test_a_check_that_has_not_been_finished_is_no_outcome(checker, monkeypatch):
    (mutant,) = (m for m in checker.WRONG_EXPLORERS if m.name == "mirror-image")
    stopped = replace(check(mutant.explorer(), edges=1), ending=Stopped("the time limit"))
    monkeypatch.setattr(checker, "check", lambda *_, **__: stopped)
    with pytest.raises(checker.NoVerdict, match="inconclusive"):
        checker.package_outcome(mutant, 1)


def test_an_explorer_that_only_one_has_seen_to_be_no_function_decides_nothing(checker, monkeypatch):
    (mutant,) = (m for m in checker.WRONG_EXPLORERS if m.name == "state-kept")
    monkeypatch.setattr(checker, "WRONG_EXPLORERS", (mutant,))
    monkeypatch.setattr(checker, "EQUIVALENT_EXPLORERS", ())
    held = {"verdict": "holds", "runs": 1, "open": []}
    monkeypatch.setattr(checker, "asked", lambda *_: held)
    for verdict in ("no function", "refuted"):
        monkeypatch.setattr(checker, "package_outcome", lambda *_, v=verdict: checker.Outcome(v))
        if verdict == "refuted":
            assert not checker.checkers_agree(1)
            continue
        with pytest.raises(checker.NoVerdict, match="only one has seen state-kept answer"):
            checker.checkers_agree(1)


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


def test_the_compiled_judge_is_asked_too(folding, tmp_path, monkeypatch):
    impostor(folding, tmp_path, monkeypatch, lambda folded: folded)
    monkeypatch.setattr(folding, "folds_compiled", lambda _world, _log: True)
    assert not folding.foldings_agree(2)
