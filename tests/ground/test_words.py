"""Numbers and lists in words."""

import pytest

from allworlds.words import darts, number, plural, size


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
