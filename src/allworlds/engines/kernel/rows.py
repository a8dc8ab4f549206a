"""The requests to the engines, and the results: plain numbers."""

from __future__ import annotations

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


class Rows(Struct, frozen=True):
    """The outcome of a piece of work.

    Attributes:
        counts: for each number of vertices that occurs.
        events: the number of occurrences of each event of Algorithm 1.
        met: (n, d0, D) for all runs, with 0 for numbers on which the bound does not depend.
        most_expensive: for each number of vertices the least of the runs that cost most.
        broken: the least runs that break a law, ascending.
    """

    counts: tuple[Counts, ...]
    events: dict[str, int]
    met: tuple[tuple[int, int, int], ...]
    most_expensive: tuple[At, ...]
    broken: tuple[BrokenRun, ...]
