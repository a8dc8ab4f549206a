"""The verb explain."""

import json

import pytest

from allworlds.checker import check
from allworlds.cli.app import call
from allworlds.explaining import explain
from allworlds.mutation.explorers import PoseLost, WrongExplorer

FINDING = check(WrongExplorer(PoseLost).explorer(), edges=2).findings[0]


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "finding.json"
    path.write_text(json.dumps(FINDING.to_json()), encoding="utf-8")
    return path


def test_it_prints_the_sentences(file, capsys):
    assert call(["explain", str(file)]) == 0
    out = " ".join(capsys.readouterr().out.split())
    for sentence in explain(FINDING).sentences:
        assert sentence in out


def test_it_prints_json(file, capsys):
    assert call(["explain", str(file), "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == explain(FINDING).to_json()


def test_it_takes_a_report_too(file, capsys):
    report = check(WrongExplorer(PoseLost).explorer(), edges=2)
    file.write_text(json.dumps(report.to_json()), encoding="utf-8")
    assert call(["explain", str(file), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["law"] == "pose"


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"version": 7}, "7"),
        ({"law": "nonsense"}, "nonsense"),
        ({"transcript": [{"percept": {"degree": 9}}]}, "degree 9"),
        ({"seen": "nothing"}, "nothing"),
        (
            {
                "transcript": [
                    *FINDING.transcript.to_json(),
                    {"drop": True, "percept": {"degree": 4}},
                ]
            },
            "",
        ),
    ],
)
def test_a_bad_finding_is_one_line_and_exit_code_2(change, named, file, capsys):
    file.write_text(json.dumps({**FINDING.to_json(), **change}), encoding="utf-8")
    assert call(["explain", str(file)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    assert named in err


def test_its_help_starts_with_an_example(capsys):
    assert call(["explain", "--help"]) == 0
    assert "Example: allworlds explain finding.json" in capsys.readouterr().out
