"""The engines of the kernel against each other, and against the Python engine."""

from collections import Counter

import pytest

from allworlds.engines.compiled_engine import (
    AGREED,
    level_of,
)
from allworlds.engines.kernel.engine import judge, walk
from allworlds.judging.findings.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import prefixes

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.fixture(autouse=True)
def fresh_comparison():
    AGREED.clear()
    yield
    AGREED.clear()


def asked(edges, policy="fifo", limit=None):
    return level_of("algorithm1", Rules(policy=policy), Extent(MapClass.MAPS, edges, limit), edges)


def level(does, edges, policy="fifo", limit=None):
    """{vertices: worlds, runs, traversals, and so on}, and the events, summed over the units."""
    total, events = {}, Counter()
    for prefix in prefixes(edges, vertices=limit, depth=2):
        rows = does(asked(edges, policy, limit), prefix)
        assert not rows.broken
        events.update(rows.events)
        for row in rows.counts:
            total.setdefault(row.vertices, Counter()).update(
                {name: getattr(row, name) for name in ("worlds", "runs", "traversals", "loops")},
                rooted=row.traversals_rooted,
                parallels=row.parallels,
                checkpoints=row.checkpoints,
            )
            kept = total[row.vertices]
            kept["largest"] = max(kept["largest"], row.largest)
    return total, events


def test_a_limit_of_vertices_leaves_the_other_worlds_as_they_are():
    whole, _ = level(walk, 5)
    for limit in range(2, 6):
        walked = level(walk, 5, limit=limit)
        assert walked[0] == {n: row for n, row in whole.items() if n <= limit}
        assert level(judge, 5, limit=limit) == walked
