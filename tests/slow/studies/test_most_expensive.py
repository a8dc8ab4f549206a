"""The most expensive run of each size is the least of those that cost most, in every engine."""

import pytest

from allworlds.engines.compiled_engine import level_of
from allworlds.engines.kernel.engine import judge, walk
from allworlds.judging.rules import Rules
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.enumeration import prefixes
from allworlds.studies.check.exhaustive import check
from studies.test_most_expensive import most_expensive


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest"])
def test_where_worlds_are_walked_once_it_is_the_same_as_where_every_run_is_judged(policy):
    rules, extent = Rules(policy=policy), Extent(MapClass.MAPS, 5)
    level = level_of("algorithm1", rules, extent, 5)
    for prefix in prefixes(5, depth=1):
        judged, walked = (does(level, prefix) for does in (judge, walk))
        assert judged.most_expensive == walked.most_expensive
        assert [run.vertices for run in walked.most_expensive] == [
            row.vertices for row in walked.counts
        ]


@pytest.mark.slowest
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
