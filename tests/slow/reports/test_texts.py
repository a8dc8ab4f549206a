import sys

import pytest

from allworlds.reports.plain_text import finding_in_words as finding_text
from allworlds.studies.check.exhaustive import check
from reports.test_texts import check_text

pytestmark = pytest.mark.usefixtures("without_workers")


def answering(darts):
    """An explorer that takes every world for one vertex with so many darts."""
    from allworlds import CombinatorialMap, Estimate

    half = darts // 2

    def explore(first):
        sigma = [*range(1, darts), 0]
        return Estimate(CombinatorialMap(sigma, [*range(half, darts), *range(half)]), 0)
        yield

    return explore


def test_a_huge_answer_is_a_short_text_and_a_whole_document():
    report = check(answering(20_000), edges=1)
    text = check_text(report, 100)
    assert len(text) < 5_000
    assert "(19,960 darts more)" in text
    assert len(report.to_json()["findings"][0]["seen"]["sigma"]) == 20_000


@pytest.mark.slowest
def test_the_time_for_the_text_of_a_huge_answer_grows_no_faster_than_the_answer():
    def calls(darts):
        finding = check(answering(darts), edges=1).findings[0]
        counted = 0

        def count_call(*_):
            nonlocal counted
            counted += 1

        sys.setprofile(count_call)
        try:
            finding_text(finding, 100)
        finally:
            sys.setprofile(None)
        return counted

    # The number of calls, not the seconds: those depend on the machine.
    assert calls(8000) < 2.5 * calls(4000)
