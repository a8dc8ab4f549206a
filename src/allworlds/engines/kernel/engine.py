"""A piece of a level, done by one of the compiled engines: plain numbers in, plain rows out.

:func:`judge` plays and judges every run; :func:`walk` walks Algorithm 1 once in each rooted map
and counts the walk for every bearing of the lighthouse.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from typing import Any

from numpy import argwhere, array, asarray, int8, int64, zeros

from allworlds.engines.kernel import demand_driven as walks, runs
from allworlds.engines.kernel.algorithm1 import explorer_addresses
from allworlds.engines.kernel.capabilities import EVENTS, EXPLORERS, POLICIES
from allworlds.engines.kernel.gluing import gluing_rule, rule_address
from allworlds.engines.kernel.laws import LAWS
from allworlds.engines.kernel.records import JOB, ROBOT, WALK, Kept, new
from allworlds.engines.kernel.rows import At, BrokenRun, Counts, Level, Rows
from allworlds.engines.kernel.worlds import lighthouse_address


def judge(level: Level, prefix: Sequence[int], *, keep: int = 1, halt: Any = None) -> Rows:
    """Play and judge every run of the maps whose gluing begins with ``prefix``.

    Args:
        level: the request.
        prefix: the first decisions, at least one (:func:`allworlds.maps.enumeration.prefixes`).
        keep: the number of broken runs that are kept, each the least of its law and map.
        halt: an array; once its entry 0 is not 0 the work is given up, and its result is void.

    Cost: some microseconds a run; constant memory.
    """
    job, robot = new(JOB), new(ROBOT)
    set_up(job, robot, level)
    unit = unit_of(level, prefix, keep)
    runs.examine(job, job.explorer, unit, flag() if halt is None else halt)
    return rows_of(unit, job, robot)


def rows_of(unit: runs.UnitArrays, job: Any, robot: Any) -> Rows:
    """The rows of the judge's results."""
    darts, kept = 2 * int(job.gluing.edges), unit.kept
    rows = enumerate(unit.counts.tolist())
    return Rows(
        tuple(Counts(n, *row) for n, row in rows if row[runs.WORLDS]),
        dict(zip(EVENTS, robot.events.tolist(), strict=False)),
        tuple((n, d0, largest) for n, d0, largest in argwhere(unit.met).tolist()),
        tuple(_at(row, darts) for row in kept.most_expensive.tolist() if row[0]),
        tuple(
            BrokenRun(*_at(row, darts), LAWS[row[2 + 2 * darts]])
            for row in kept.least.tolist()
            if row[0]
        ),
    )


def unit_of(level: Level, prefix: Sequence[int], keep: int = 1) -> runs.UnitArrays:
    """The arrays of the judge, with room for its results."""
    bounds = array(level.bounds, int64)
    return runs.UnitArrays(
        array(prefix, int64),
        gluing_rule(level.edges),
        bounds,
        zeros(bounds.shape, int8),
        array(level.budgets, int64),
        zeros((level.edges + 2, runs.COLUMNS), int64),
        _rooms(level.edges, keep),
    )


def _rooms(edges: int, keep: int) -> Kept:
    """Room for the runs that are kept."""
    width = 3 + 8 * edges
    most_expensive, least = (zeros((many, width), int64) for many in (edges + 2, keep))
    return Kept(most_expensive, least, zeros(width, int64))


def compile_apart(explorer: str) -> None:
    """Let another process compile an explorer, and leave it in the cache.

    Without a cache that can be written to, this has no effect.
    """
    in_another_process(f"from {__name__} import explorer_addresses as a; a({explorer!r})").wait()


def in_another_process(code: str) -> subprocess.Popen[bytes]:
    """The process, which runs the code; it finds the same modules, and its prints are dropped."""
    program = f"import json, sys; sys.path[:] = json.loads(sys.argv[1]); {code}"
    command, no = [sys.executable, "-c", program, json.dumps(sys.path)], subprocess.DEVNULL
    return subprocess.Popen(command, stdin=no, stdout=no, stderr=no)  # noqa: S603  # ours


def set_up(job: Any, robot: Any, level: Level) -> None:
    """Fill a new job and a new robot with the request of the level."""
    job.lighthouse = lighthouse_address(level.lighthouse)
    job.laws = sum(1 << LAWS.index(law) for law in level.laws)
    job.until = 1 << 62
    gluing = job.gluing
    gluing.edges, gluing.limit = level.edges, level.limit
    gluing.simple, gluing.planar = level.simple, level.planar
    gluing.rule = rule_address() if level.simple or level.planar else 0
    robot.policy, robot.natural = POLICIES[level.policy], level.explorer == "algorithm1-natural"
    explorer = job.explorer
    if level.explorer in EXPLORERS:
        explorer.start, explorer.step, explorer.answer = explorer_addresses(level.explorer)
    explorer.state = asarray(robot).ctypes.data


def _at(row: list[int], darts: int) -> At:
    """The run of a row."""
    n, *code = row
    return At(n, tuple(code[:darts]), tuple(code[darts : 2 * darts]), code[2 * darts])


def walk(level: Level, prefix: Sequence[int], *, keep: int = 1, halt: Any = None) -> Rows:
    """Walk Algorithm 1 once in every map whose gluing begins with ``prefix``.

    The class is ``maps``, the lighthouse directional, all laws are checked together, and the
    bound depends on n alone; a walk that costs more than the largest budget has failed.  A broken
    world is one in which some law is broken at some place.

    The arguments are those of :func:`judge`.

    Cost: less than 100 ns a world; constant memory.
    """
    edges, darts, places = level.edges, 2 * level.edges, -prefix[0]
    w, viable, kept = new(WALK), gluing_rule(edges), _rooms(edges, keep)
    w.edges, w.limit, w.policy = edges, level.limit, POLICIES[level.policy]
    w.fuel = max(level.budgets)
    w.bound[: len(level.bounds)] = [bound for ((bound, *_), *_) in level.bounds]
    w.viable[: len(viable), : viable.shape[1]] = viable
    walks.explore(w, array(prefix, int64), kept, flag() if halt is None else halt)
    rows = w.counts[: edges + 2].tolist()
    return Rows(
        tuple(_walked_counts(n, row, edges, places) for n, row in enumerate(rows) if row[0]),
        _walked_events(rows, edges, places),
        tuple((n, 0, 0) for n, row in enumerate(rows) if row[0]),
        tuple(_at(row, darts) for row in kept.most_expensive.tolist() if row[0]),
        tuple(BrokenRun(*_at(row, darts)[:3], None, "") for row in kept.least.tolist() if row[0]),
    )


def _walked_counts(n: int, row: list[int], edges: int, places: int) -> Counts:
    worlds, cost = row[walks.WORLDS], row[walks.TRAVERSALS]
    of_runs = places * worlds, places * cost, cost, row[walks.LARGEST], places * worlds * edges, 0
    return Counts(n, worlds, *of_runs, row[walks.LOOP_EDGE], row[walks.PARALLEL_EDGE])


def _walked_events(rows: list[list[int]], edges: int, places: int) -> dict[str, int]:
    counted = [walks.CASES_1, walks.CASES_2, walks.TESTS_AT_V0, walks.EMPTY_HS]
    case_1, case_2, at_v0, empty = (sum(row[column] for row in rows) for column in counted)
    ended = [row[walks.WORLDS] - row[walks.FAILURES] for row in rows]
    loops = sum((edges - n + 1) * times for n, times in enumerate(ended))
    others = sum((n - 1) * times for n, times in enumerate(ended))
    events = case_1, case_2, loops, at_v0, empty, loops, others
    return {event: places * times for event, times in zip(EVENTS, events, strict=True)}


def flag() -> Any:
    """An array with one entry, 0: the flag by which work in threads is given up."""
    return zeros(1, int64)
