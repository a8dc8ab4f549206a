"""Numbers and lists in words."""

import pytest

from allworlds.words import about, darts, duration, number, plural, size


def test_a_size_is_told_in_edges_and_vertices():
    assert size(1, 2) == "1 edge and 2 vertices"
    assert size(2, 1) == "2 edges and 1 vertex"


def test_only_one_is_singular():
    assert [plural(n, "edge") for n in range(3)] == ["0 edges", "1 edge", "2 edges"]
    assert [plural(n, "class", "classes") for n in (1, 2)] == ["1 class", "2 classes"]


def test_thousands_are_separated():
    assert number(999) == "999"
    assert plural(1_234_567, "run") == "1,234,567 runs"


@pytest.mark.parametrize(
    ("names", "words"),
    [("1", "dart 1"), ("13", "darts 1 and 3"), ("135", "darts 1, 3 and 5")],
)
def test_the_last_of_several_darts_follows_an_and(names, words):
    assert darts(names) == words


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (12, "12 s"),
        (300, "5 min"),
        (12_000, "3 h 20 min"),
        (4 * 86_400 + 3 * 3600, "4 days 3 h"),
        (70_499 * 365 * 86_400.0, "70,000 years"),
        (3 * 365 * 86_400, "3 years"),
        (1e300, "more than 1,000,000,000,000 years"),
    ],
)
def test_a_duration_is_rounded_to_what_one_can_imagine(seconds, words):
    assert duration(seconds) == words


def test_a_number_of_many_digits_is_told_by_the_first_two():
    assert about(123_456_789_012_345) == "123,456,789,012,345"
    assert about(637 * 10**74) == "6.3 x 10^76"
