import pytest

from allworlds.documents.document import replace
from allworlds.studies.run import replay
from judging import test_finding as quick
from judging.test_finding import algorithm

finding = quick.finding
one_schedule = quick.one_schedule


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("choices", "notice"),
    [
        ((1, 0), ""),
        ((1, 0, 0), "the recorded choice 2 is 0, but only 2 were asked for"),
        ((1, 5), "the recorded choice 1 is 5, but there are fewer options"),
    ],
)
def test_recorded_choices_that_do_not_fit_are_told(one_schedule, choices, notice):
    finding = replace(one_schedule, choices=choices)
    assert replay(finding).notice.startswith(notice)
    assert not replay(finding, algorithm).notice
