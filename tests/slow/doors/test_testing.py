"""Assertions for authors' test suites: what they let pass, and what they say when they fail."""

import pytest

from allworlds.testing import assert_conforms, assert_explores, conformance
from doors import test_testing as quick
from doors.test_testing import RIGHT, wrong

cubic_alone = quick.cubic_alone

pytestmark = pytest.mark.usefixtures("without_workers")


@pytest.mark.slowest
def test_a_right_explorer_passes_and_the_report_says_how_much_was_tried():
    report = assert_explores(RIGHT, edges=3, corpus=None)
    assert (report.worlds, report.runs) == (86, 309)
    assert assert_explores("algorithm1", corpus=None).scope.edges == 4


@pytest.mark.slowest
def test_under_a_condition_no_part_of_the_kit_leaves_it(cubic_alone):
    assert_conforms(cubic_alone, edges=3, drawn=3, where="cubic")
    with pytest.raises(AssertionError, match="known-hard-maps"):
        assert_conforms(cubic_alone, edges=3, drawn=3)
    *_, last = conformance(cubic_alone, edges=3, drawn=3, where="eulerian")
    assert str(last) == "drawn-maps"
    with pytest.raises(AssertionError, match="crash"):
        last()


def test_what_conforms_no_longer_is_told_with_the_part():
    with pytest.raises(AssertionError, match=r"^known-hard-maps: REFUTED: law pose is broken\n"):
        assert_conforms(wrong(), corpus=None)
