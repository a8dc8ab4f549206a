"""Sensors: the theorem to degree 8, and the weakest of 203."""

import pytest

from allworlds.ambiguity import weakest
from studies import test_sensors as quick

SENSORS = quick.HERE.parents[1] / "papers" / "minimal_information" / "sensors.py"

LARGER = {5, 7}
"""Degrees of which the twins of constant words have as many edges at least."""


@pytest.mark.slowest
@pytest.mark.parametrize("degree", range(1, 9))
def test_a_word_suffices_if_it_is_primitive_and_not_blank(degree):
    found = quick.disagreements(degree, 4)
    assert all(len({*word}) == 1 for word in found)
    assert len(found) == (3 if degree in LARGER else 0)


@pytest.mark.slowest
def test_twenty_two_of_two_hundred_and_three_sensors_are_the_weakest():
    report = weakest(f"{SENSORS}:Features", edges=4)
    assert (report.coarsenings, report.sufficient, len(report.minimal)) == (203, 139, 22)
    pairs = [one.letters for one in report.minimal if len(one.letters) == 2]
    bits = {tuple(sorted(block)) for pair in pairs for block in pair if "away" not in block}
    assert bits == {
        ("door",),
        ("behind",),
        ("behind", "door", "next"),
        ("neighbour", "other"),
        ("door", "neighbour", "next"),
    }


@pytest.mark.slowest
def test_with_five_edges_three_of_the_weakest_have_twins():
    report = weakest(f"{SENSORS}:Features", edges=5)
    assert (report.sufficient, len(report.minimal)) == (135, 19)
