"""The exact worst case of Algorithm 1, by the number of edges."""

from __future__ import annotations

from collections.abc import Iterable

from allworlds import worst
from allworlds.claims import EverySchedule, Found, Means, Unfinished, truth
from allworlds.maps import rooted_maps

READABLE_EDGES = 3
"""The largest m for which the readable search over schedules takes seconds."""


def exact_worst(means: Means, *, edges: int) -> Found:
    """The exact worst cost of Algorithm 1, by the number of edges.

    It is attained by the run that is replayed of each size; that no schedule costs more is said
    by the compiled search, and in small worlds by the readable one, too.
    """
    report = worst(edges=edges, workers=means.workers).uninterrupted()
    if not report.agrees:
        raise Unfinished("the worst cases are not those of their replays")
    costs = _largest((row.edges, row.worst) for row in report.rows)
    attained = sum(row.replayed == row.worst for row in report.rows)
    again = [
        (m, EverySchedule(map_, 0).worst)
        for m in range(1, min(edges, READABLE_EDGES) + 1)
        for map_ in rooted_maps(m)
    ]
    agree = all(costs[m] == cost for m, cost in _largest(again).items())
    seen = {
        "worlds": sum(row.worlds for row in report.rows),
        "sizes that a run attains": attained,
        "worlds searched twice": len(again),
    }
    holds = agree and attained == len(report.rows)
    return Found(truth(holds), seen, {"worst": list(costs.values())})


def _largest(costs: Iterable[tuple[int, int]]) -> dict[int, int]:
    """The largest cost, by number of edges."""
    largest: dict[int, int] = {}
    for edges, cost in costs:
        largest[edges] = max(largest.get(edges, 0), cost)
    return largest
