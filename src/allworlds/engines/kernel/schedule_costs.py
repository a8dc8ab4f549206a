"""The most expensive schedules of a piece of a level: plain numbers in, plain rows out."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from numpy import array, int64, zeros

from allworlds.engines.kernel.gluing import rule_address
from allworlds.engines.kernel.records import SCHEDULES, new
from allworlds.engines.kernel.schedules import COLUMNS, SHORTEST, SIMPLE, Rooms, search
from allworlds.engines.kernel.tables import gluing_rule

_TRANSITS = {"shortest": SHORTEST, "simple": SIMPLE}


class ScheduleCosts(NamedTuple):
    """The costs over all schedules in the maps of one size.

    Attributes:
        vertices: n.
        rooted: rooted maps.
        worst: the largest cost of a schedule.
        best: the largest, over the worlds, of the cost of the cheapest schedule.
        tests: different tests, on every simple path, in the worlds worked on.
        wrong: the number of them that confirmed a false hypothesis.
        sigma, alpha: the least code of a world that attains the worst cost.
    """

    vertices: int
    rooted: int
    worst: int
    best: int
    tests: int
    wrong: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]


def schedule_costs_of_unit(
    edges: int,
    limit: int,
    prefix: Sequence[int],
    transit: str,
    halt: Any,
    *,
    simple: bool = False,
    planar: bool = False,
) -> list[ScheduleCosts]:
    """The schedule costs of every map of a class whose gluing begins with ``prefix``.

    Args:
        edges: m.
        limit: the largest number of vertices.
        prefix: the first decisions, at least one.
        transit: ``shortest`` or ``simple``.
        halt: an array; once its entry 0 is not 0 the work is given up, and its result is void.
        simple: whether the class has no loops and no parallel edges.
        planar: whether it has genus 0.
    """
    job = new(SCHEDULES)
    job.transit = _TRANSITS[transit]
    gluing = job.gluing
    gluing.edges, gluing.limit, gluing.simple, gluing.planar = edges, limit, simple, planar
    gluing.rule = rule_address() if simple or planar else 0
    sets, width = 1 << edges, 1 + 4 * edges
    costs, counts, rows = (sets, edges + 1), (edges + 2, COLUMNS), (edges + 2, width)
    shapes: tuple[Any, ...] = (costs, costs, sets, counts, rows, width, width)
    rooms = Rooms(*(zeros(shape, int64) for shape in shapes))
    search(job, array(prefix, int64), gluing_rule(edges), rooms, halt)
    found = []
    for n, (rooted, most, least, tests, wrong) in enumerate(rooms.counts.tolist()):
        known, *code = rooms.rows[n].tolist()
        sigma, alpha = (code[: 2 * edges], code[2 * edges :]) if known else ([], [])
        if rooted:
            found.append(
                ScheduleCosts(n, rooted, most, least, tests, wrong, tuple(sigma), tuple(alpha))
            )
    return found
