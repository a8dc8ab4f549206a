"""The finding of a file that is meant, by its number."""

import json

import pytest

import allworlds
from allworlds.inputs.checks import InputError
from allworlds.studies.findings import FindingWords


@pytest.fixture
def report(tmp_path):
    """A file with a report, as a function of the number of its findings."""
    document = allworlds.check("dudek91", edges=2).to_json()

    def written(count):
        file = tmp_path / "report.json"
        file.write_text(json.dumps({**document, "findings": document["findings"] * count}))
        return str(file)

    return written


@pytest.mark.parametrize(
    ("count", "number", "told"),
    [
        (1, 1, None),
        (3, 3, None),
        (3, 0, "finding = 0 is not there: the file holds findings 1 to 3"),
        (3, 4, "finding = 4 is not there: the file holds findings 1 to 3"),
        (1, 2, "finding = 2 is not there: the file holds 1 finding"),
    ],
)
def test_findings_are_numbered_from_1(report, count, number, told):
    words = FindingWords(file=report(count), number=number)
    if told is None:
        chosen = words.chosen()
        assert (chosen.number, chosen.findings, chosen.finding.law) == (number, count, "map")
    else:
        with pytest.raises(InputError) as refused:
            words.chosen()
        assert str(refused.value) == told
