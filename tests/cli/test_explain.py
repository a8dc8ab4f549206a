"""The verb explain."""

import json

import pytest

from allworlds import explain
from allworlds.corpus.explorers import PoseLost, WrongExplorer
from allworlds.studies.check.exhaustive import check

FINDING = check(WrongExplorer(PoseLost).explorer(), edges=2).findings[0]


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "finding.json"
    path.write_text(json.dumps(FINDING.to_json()), encoding="utf-8")
    return path


def test_it_prints_the_sentences(file, cli):
    code, out, _ = cli("explain", file)
    assert code == 0
    for sentence in explain(FINDING).sentences:
        assert sentence in " ".join(out.split())


def test_it_prints_json(file, cli):
    code, out, _ = cli("explain", file, "--json")
    document = json.loads(out)
    del document["made_by"]
    assert (code, document) == (0, explain(FINDING).to_json())


def test_it_takes_a_report_too(file, cli):
    report = check(WrongExplorer(PoseLost).explorer(), edges=2)
    file.write_text(json.dumps(report.to_json()), encoding="utf-8")
    code, out, _ = cli("explain", file, "--json")
    assert (code, json.loads(out)["law"]) == (0, "pose")


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
def test_a_bad_finding_is_one_line_and_exit_code_2(change, named, file, refused):
    file.write_text(json.dumps({**FINDING.to_json(), **change}), encoding="utf-8")
    assert named in refused("explain", file)


def test_its_help_starts_with_an_example(cli):
    code, out, _ = cli("explain", "--help")
    assert code == 0
    assert "Example: allworlds explain finding.json" in out
