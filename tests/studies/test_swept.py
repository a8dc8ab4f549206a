"""The bases of reports: what holds of a report that says nothing else."""

import pytest

from allworlds.outcome import Completed, Disagreed, Interrupted, Stopped
from allworlds.studies.reports import EndedReport
from allworlds.studies.swept import SweptReport


class Plain(EndedReport):
    """A report that says nothing of itself."""


@pytest.mark.parametrize(
    ("ending", "true"),
    [
        (Completed(), set()),
        (Stopped("late"), {"undecided"}),
        (Interrupted(), {"interrupted"}),
        (Disagreed("they differ"), {"disagrees"}),
    ],
)
def test_a_report_is_of_the_whole_agrees_and_is_not_empty(ending, true):
    report = Plain(ending=ending)
    assert report.whole is report.agrees is True
    assert report.refuted is report.empty is False
    names = ("disagrees", "interrupted", "refuted", "undecided", "vacuous")
    assert {name for name in names if getattr(report.facts, name)} == true


def test_an_interrupted_report_is_no_report_for_who_cannot_use_it():
    report = Plain(ending=Completed())
    assert report.uninterrupted() is report
    with pytest.raises(KeyboardInterrupt):
        Plain(ending=Interrupted()).uninterrupted()


def test_each_report_with_rows_has_them_as_a_key():
    with pytest.raises(NotImplementedError):
        SweptReport.rows.fget(None)
