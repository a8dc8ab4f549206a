"""The requests to the engines, and the results: plain numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from msgspec import Struct


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
        bounds: the largest legal costs by vertices, degree of v0 and largest degree; the latter two
            have one entry where the bound does not depend on them.
        budgets: the largest number of traversals, by vertices from 0 on; at most MOST_BUDGET.
    """

    edges: int
    limit: int
    simple: bool
    planar: bool
    explorer: str
    lighthouse: str
    policy: str
    laws: tuple[str, ...]
    bounds: list[list[list[int]]]
    budgets: tuple[int, ...]


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
