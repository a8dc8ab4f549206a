"""The tables of the engines: a mutant can be made here without a compiler."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from numpy import array, int64, ones

from allworlds.judging import paper_bound

UNBOUNDED = 1 << 40
"""The number in place of no bound: more than any walk costs."""

_NOTHING = -1
"""The number in place of all smaller bounds: less than any walk costs."""


class Tables(NamedTuple):
    """The tables of one level.

    Attributes:
        bound: the largest legal cost of a walk, by vertices.
        viable: by darts owed and darts open after a decision: a map can still be finished.
        sensed: the degree that the robot of a walk senses, by the degree of the vertex.
        fuel: a walk that costs more has failed.
        back_weight: the cost of a step of retracing in a walk.
    """

    bound: Any
    viable: Any
    sensed: Any
    fuel: int
    back_weight: int


def tables(edges: int, fuel: int, bounds: Sequence[int | None] = ()) -> Tables:
    """The tables of the level.

    Args:
        edges: m.
        fuel: a walk that costs more has failed.
        bounds: the largest legal cost for 1, 2, ... vertices, None if there is none;
            empty takes (1) + (2).
    """
    darts = 2 * edges
    bounds = bounds or [paper_bound(n, edges) for n in range(1, edges + 2)]
    return Tables(
        bound=array([0, *map(packed, bounds)], int64),
        viable=gluing_rule(edges),
        sensed=array(range(darts + 1), int64),
        fuel=fuel,
        back_weight=1,
    )


def gluing_rule(edges: int) -> Any:
    """The rule by darts owed and open: the last open dart may not close while darts are owed."""
    viable = ones((2 * edges + 1, 4 * edges + 1), int64)
    viable[1:, 0] = 0
    return viable


def packed(bound: int | None) -> int:
    """Clamp a bound to the kernel's integers; no verdict changes."""
    return UNBOUNDED if bound is None else max(_NOTHING, min(bound, UNBOUNDED))
