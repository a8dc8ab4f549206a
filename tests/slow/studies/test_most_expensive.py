"""The most expensive run of each size is the least of those that cost most, in every engine."""

import pytest

from studies import test_most_expensive as quick


@pytest.mark.no_cover
@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize(
    ("explorer", "map_class", "edges"),
    [("algorithm1-cluster", "maps", 3), ("algorithm1-natural", "simple", 5)],
)
def test_both_engines_find_the_same(explorer, map_class, edges):
    quick.test_both_engines_find_the_same(explorer, map_class, edges)
