"""The requests to the engines, the tables in them, and the results: plain numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from msgspec import Struct
from numpy import array, int64, ones

from allworlds.judging.laws.bounds import paper_bound

UNBOUNDED = 1 << 40
"""The number in place of no bound: more than any walk costs."""


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
    """The tables of the level; a walk that costs more than ``fuel`` has failed.

    The bounds are the largest legal costs for 1, 2, ... vertices, None for none; empty: (1) + (2).
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
    """Clamp a bound to the kernel's integers; no verdict changes, as every walk costs 0 or more."""
    return UNBOUNDED if bound is None else max(-1, min(bound, UNBOUNDED))


class LevelBounds(Struct, frozen=True):
    """The largest legal cost of every run of a level.

    Attributes:
        value: of n, d0 and D; None if there is no bound, UNDEFINED where the bound has no value.
        by_d0, by_largest: whether it depends on the degree of v0, and on the largest degree;
            other arguments are given as 0.
    """

    value: Callable[[int, int, int], int | None]
    by_d0: bool = False
    by_largest: bool = False


class Level(Struct, frozen=True, eq=False):
    """The common data of all units of a level.

    Attributes:
        edges: m, at most MOST_EDGES.
        limit: the largest number of vertices, at most m + 1.
        simple, planar: the class.
        explorer: one of :data:`allworlds.engines.kernel.capabilities.EXPLORERS`.
        lighthouse: one of :data:`allworlds.engines.kernel.capabilities.LIGHTHOUSES`.
        policy: ``fifo``, ``lifo`` or ``nearest``.
        laws: the checked ones; those before ``map`` always are.
        bounds: of the law ``bound``.
        budgets: the largest number of traversals, by vertices from 0 on; at most MOST_BUDGET.
        tables: of the engines.
    """

    edges: int
    limit: int
    simple: bool
    planar: bool
    explorer: str
    lighthouse: str
    policy: str
    laws: tuple[str, ...]
    bounds: LevelBounds
    budgets: tuple[int, ...]
    tables: Tables


class Counts(Struct, frozen=True):
    """The counts of the worlds of one size.

    Attributes:
        vertices: n.
        worlds: rooted maps.
        runs: worlds x places.
        traversals: summed over the runs.
        traversals_rooted: summed over the first place of each rooted map only.
        largest: the largest cost of a run.
        checkpoints: the number of published ones.
        left_out: worlds without a place for the lighthouse.
        loops, parallels: worlds with a loop, and with two edges that have the same two ends.
    """

    vertices: int
    worlds: int
    runs: int
    traversals: int
    traversals_rooted: int
    largest: int
    checkpoints: int
    left_out: int
    loops: int
    parallels: int


class At(NamedTuple):
    """A run, in canonical numbering.

    Attributes:
        vertices: n.
        sigma, alpha: the map, rooted at dart 0.
        place: the number of the lighthouse's place.
    """

    vertices: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int


class BrokenRun(Struct, frozen=True):
    """A run that breaks a law, in canonical numbering, as :class:`At`.

    Attributes:
        place: None for every place.
        law: the law's name; empty if the engine does not tell laws apart.
    """

    vertices: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    place: int | None
    law: str


class Listed(Struct, frozen=True):
    """One run.

    Attributes:
        law: the law that it breaks, or an empty text.
        cost: its traversals.
        checkpoints: the number of published ones.
        walk: a hash of its whole walk (:func:`walk_number`).
    """

    law: str
    cost: int
    checkpoints: int
    walk: int


class Rows(Struct, frozen=True):
    """The outcome of a piece of work.

    Attributes:
        counts: for each number of vertices that occurs.
        events: the number of occurrences of each event of Algorithm 1.
        met: (n, d0, D) for all runs, with 0 for numbers on which the bound does not depend.
        most_expensive: for each number of vertices the least of the runs that cost most; none where
            more expensive ones were known elsewhere.
        broken: the least runs that break a law, ascending.
        listed: the first runs, as many as were asked for.
    """

    counts: tuple[Counts, ...]
    events: dict[str, int]
    met: tuple[tuple[int, int, int], ...]
    most_expensive: tuple[At, ...]
    broken: tuple[BrokenRun, ...]
    listed: tuple[Listed, ...] = ()


def walk_number(steps: Sequence[tuple[int, int, int, int]]) -> int:
    """The hash of a walk: of its motions, each with degree, marks and bearing (-1: none)."""
    number = 0
    for step in steps:
        for part in step:
            number = (number * 31 + part + 1) % 2147483647
    return number
