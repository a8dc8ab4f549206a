"""Slips, claimed of the explorers that take more time, and of those of which there are none."""

import pytest

from allworlds.studies.check.exhaustive import check
from allworlds.studies.explain import explain
from judging import test_slips as quick
from judging.test_slips import mirrored, spoiling

pytestmark = pytest.mark.slowest


@pytest.fixture(scope="module", params=quick.LATER)
def findings(request):
    return quick.found_about(request.param)


@pytest.mark.slowest
def test_a_mirror_image_is_claimed_exactly_where_there_is_one(findings):
    quick.test_a_mirror_image_is_claimed_exactly_where_there_is_one(findings)


def test_whatever_slip_is_claimed_the_answer_is_right_without_it(findings):
    quick.test_whatever_slip_is_claimed_the_answer_is_right_without_it(findings)


def test_an_answer_is_called_guessed_only_where_its_world_fits_the_whole_log(findings):
    quick.test_an_answer_is_called_guessed_only_where_its_world_fits_the_whole_log(findings)


def test_bearings_that_are_read_the_right_way_round_are_not_suspected(findings):
    quick.test_bearings_that_are_read_the_right_way_round_are_not_suspected(findings)


@pytest.mark.slowest
def test_the_slip_stands_in_the_explanation():
    (finding,) = check(spoiling(mirrored), edges=4, laws=("map",)).findings
    told = explain(finding)
    assert told.slip == told.to_json()["slip"] == "mirror image"
    assert "mirror image" in told.sentences[0]
