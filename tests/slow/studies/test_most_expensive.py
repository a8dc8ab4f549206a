"""The most expensive run of each size is the least of those that cost most, in every engine."""

import pytest

from allworlds.studies.check.exhaustive import check
from studies.test_most_expensive import most_expensive


@pytest.mark.long
@pytest.mark.no_cover
@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize(
    ("explorer", "map_class", "edges"),
    [
        ("algorithm1", "maps", 4),
        ("algorithm1", "planar", 4),
        ("algorithm1-cluster", "maps", 3),
        ("algorithm1-natural", "simple", 5),
    ],
)
def test_both_engines_find_the_same(explorer, map_class, edges):
    by_python, by_kernel = (
        check(explorer, map_class=map_class, edges=edges, engine=engine)
        for engine in ("python", "kernel")
    )
    assert most_expensive(by_python) == most_expensive(by_kernel)
