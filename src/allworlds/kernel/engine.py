"""A piece of a level, done by one of the compiled engines: plain numbers in, plain rows out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, TypeAlias

from numpy import array, int64, zeros

from allworlds.kernel import gluing, thorough, walk
from allworlds.kernel.names import (
    AT_V0,
    BROKEN,
    CASE_1,
    CASE_2,
    COLUMNS,
    EMPTY_H,
    FAILED,
    LARGEST,
    LOOP_EDGE,
    PARALLEL_EDGE,
    POLICIES,
    TRAVERSALS,
    WORLDS,
)
from allworlds.kernel.tables import Tables, tables

Mode: TypeAlias = Literal["walk", "thorough"]
"""``walk``: worlds are decided where the robot looks; ``thorough``: each is finished first."""

COMPILING = "compiling the kernel; this is done once and takes some seconds"
"""The notice for a first use."""

_ENGINES = {"walk": walk.explore, "thorough": thorough.examine}


@dataclass(frozen=True, slots=True)
class Counts:
    """What one walk of each rooted map, at one bearing, has shown in the maps of one size.

    Attributes:
        vertices: n.
        worlds: rooted maps.
        broken: those in which a law is broken.
        traversals: summed over the worlds; where a walk has failed it is not counted.
        largest: the largest cost of a walk.
        per_walk: how often each event occurred, summed over the walks.
        per_world: in how many worlds there is such a thing.
    """

    vertices: int
    worlds: int
    broken: int
    traversals: int
    largest: int
    per_walk: dict[str, int]
    per_world: dict[str, int]


@dataclass(frozen=True, slots=True)
class Rows:
    """The outcome of a piece of work.

    Attributes:
        counts: for each number of vertices that occurs.
        broken: the least worlds that break a law, as (vertices, sigma, alpha), ascending.
    """

    counts: tuple[Counts, ...]
    broken: tuple[tuple[int, tuple[int, ...], tuple[int, ...]], ...]


def examine(
    edges: int,
    limit: int,
    policy: str,
    prefix: Sequence[int],
    tables: Tables,
    *,
    mode: Mode = "walk",
    keep: int = 1,
    halt: Any = None,
) -> Rows:
    """Every map of the class ``maps`` whose gluing begins with ``prefix``, walked once.

    Args:
        edges: m.
        limit: the largest number of vertices.
        policy: ``fifo``, ``lifo`` or ``nearest``.
        prefix: the first decisions, at least one (:func:`allworlds.maps.enumeration.prefixes`).
        tables: of the level.
        mode: which engine.
        keep: how many broken worlds are kept.
        halt: an array; once its entry 0 is not 0 the work is given up, and means nothing.

    Cost: some dozen nanoseconds a world; constant memory.
    """
    counts = zeros((edges + 2, COLUMNS), int64)
    least = zeros((keep, 1 + 4 * edges), int64)
    _call(mode, edges, limit, policy, prefix, tables, halt, counts, least, _no_list())
    rows = [_counts(n, edges, row) for n, row in enumerate(counts.tolist()) if row[WORLDS]]
    darts = 2 * edges
    broken = tuple(
        (row[0], tuple(row[1 : 1 + darts]), tuple(row[1 + darts :]))
        for row in least.tolist()
        if row[0]
    )
    return Rows(tuple(rows), broken)


def costs(
    edges: int, policy: str, prefix: Sequence[int], tables: Tables, worlds: int, *, mode: Mode
) -> list[tuple[int, tuple[int, ...], tuple[int, ...]]]:
    """For each world whose walk ended ``(cost, degrees, partners)``: its dart 0 is the start.

    The darts of a vertex are consecutive and clockwise; ``worlds`` is the largest number
    that is listed.
    """
    counts = zeros((edges + 2, COLUMNS), int64)
    least = zeros((1, 1 + 4 * edges), int64)
    listed = zeros((worlds, 4 + 3 * edges), int64)
    found = _call(mode, edges, edges + 1, policy, prefix, tables, None, counts, least, listed)
    result = []
    for cost, n, *rest in listed[:found].tolist():
        if n:
            result.append((cost, tuple(rest[:n]), tuple(rest[n : n + 2 * edges])))
    return result


def flag() -> Any:
    """An array with one entry, 0: the flag by which work in threads is given up."""
    return zeros(1, int64)


def is_compiled(function: Any) -> bool:
    """Whether an earlier use has left what ``function`` compiles to behind."""
    source = Path(function.py_func.__code__.co_filename)
    compiled = Path(str(function.stats.cache_path)).glob(
        f"{source.stem}.{function.py_func.__name__}-*.nbi"
    )
    return any(file.stat().st_mtime >= source.stat().st_mtime for file in compiled)


def _counts(n: int, edges: int, row: list[int]) -> Counts:
    walks = row[WORLDS] - row[FAILED]
    loops = (edges - n + 1) * walks
    per_walk = {
        "case-1": row[CASE_1],
        "case-2": row[CASE_2],
        "case-3": loops,
        "v0-hypothesis": row[AT_V0],
        "empty-H": row[EMPTY_H],
        "loop": loops,
        "non-loop": (n - 1) * walks,
    }
    per_world = {"loop-edge": row[LOOP_EDGE], "parallel-edge": row[PARALLEL_EDGE]}
    return Counts(n, row[WORLDS], row[BROKEN], row[TRAVERSALS], row[LARGEST], per_walk, per_world)


def _no_list() -> Any:
    return zeros((0, 1), int64)


def _call(
    mode: Mode,
    edges: int,
    limit: int,
    policy: str,
    prefix: Sequence[int],
    tables: Tables,
    halt: Any,
    *outputs: Any,
) -> int:
    halt = flag() if halt is None else halt
    start = array(prefix, int64)
    found: int = _ENGINES[mode](edges, limit, POLICIES[policy], start, tables, halt, *outputs)
    return found


def by_vertices_and_faces(
    edges: int, limit: int, prefix: Sequence[int]
) -> dict[tuple[int, int], int]:
    """How many maps there are whose gluing begins with ``prefix``, by (vertices, faces).

    Cost: less than 100 ns a map; constant memory.
    """
    counts = zeros((edges + 2, edges + 3), int64)
    gluing.count(edges, limit, array(prefix, int64), tables(edges, 0).viable, counts)
    rows = counts.tolist()
    return {(n, f): count for n, row in enumerate(rows) for f, count in enumerate(row) if count}
