"""Numbers and enumerations in words."""

import pytest

from allworlds.explaining.words import count, darts, size
from allworlds.maps import named_map


@pytest.mark.parametrize(
    ("name", "words"),
    [("edge", "2 vertices and 1 edge"), ("two-loops-torus", "1 vertex and 2 edges")],
)
def test_a_maps_size_is_told_in_vertices_and_edges(name, words):
    assert size(named_map(name)) == words


def test_only_one_is_singular():
    assert [count(n, "edge") for n in range(3)] == ["0 edges", "1 edge", "2 edges"]


@pytest.mark.parametrize(
    ("names", "words"),
    [("1", "dart 1"), ("13", "darts 1 and 3"), ("135", "darts 1, 3 and 5")],
)
def test_the_last_of_several_darts_follows_an_and(names, words):
    assert darts(names) == words
