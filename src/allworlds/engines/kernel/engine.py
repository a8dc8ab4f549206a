"""The compiled engines for a unit of a level; requests and results are plain numbers.

The request is a :class:`Level`: sizes, explorer, lighthouse and rules, which are the same for all
units of a level.  A unit is given by its prefix: the first decisions by which its maps are made.

For a built-in explorer, :func:`judge` plays and judges every run; :func:`walk` walks Algorithm 1
once in each rooted map, and counts the walk for every direction of the lighthouse.

For a user's explorer this module only lays out the runs of a unit and judges their logs; other
processes play the runs.  To *lay out* runs is to write their worlds to memory, so that a player
need not enumerate maps, and can play the runs in any order.
"""

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from typing import Any

from msgspec import Struct
from numpy import argwhere, array, asarray, int8, int64, zeros

from allworlds.engines.kernel import arrays as layout, demand_driven as walks, runs
from allworlds.engines.kernel.algorithm1 import explorer_addresses
from allworlds.engines.kernel.arrays import (
    JOB,
    LOG_BYTES,
    NONE,
    READER,
    ROBOT,
    WALK,
    At,
    BrokenRun,
    Counts,
    Kept,
    Level,
    Stretch,
    Sums,
    new,
)
from allworlds.engines.kernel.capabilities import EVENTS, EXPLORERS, POLICIES
from allworlds.engines.kernel.compiling import call, entry
from allworlds.engines.kernel.laws import LAWS
from allworlds.engines.kernel.worlds import (
    advance,
    gluing_rule,
    lighthouse_address,
    rule_address,
    settle,
)
from allworlds.engines.linux import COMPILER


def judge(level: Level, prefix: Sequence[int], *, keep: int = 1, halt: Any = None) -> Sums:
    """Play and judge every run of the maps whose first decisions are ``prefix``.

    Return the sums of the results: counts, the most expensive runs, and runs that break a law.

    Args:
        level: the request: the number of edges, the explorer, the lighthouse and the rules.
        prefix: the first decisions, at least one, by which these maps are made
            (:func:`allworlds.maps.enumeration.prefixes`).
        keep: the largest number of runs that break a law and are kept; of all runs that break the
            same law in the same map only the first is kept.
        halt: an array of one number; once this number is not 0, the work is given up, and its
            result is void.  None if the work is never given up.

    Cost: some microseconds for a run; constant memory.
    """
    job, robot = new(JOB), new(ROBOT)
    set_up(job, robot, level)
    unit = unit_of(level, prefix, keep)
    runs.examine(job, job.explorer, unit, flag() if halt is None else halt)
    return sums_of(unit, job, robot)


def sums_of(unit: runs.UnitArrays, job: Any, robot: Any) -> Sums:
    """The results of a unit, which the judge has written to arrays, as :class:`Sums`.

    Args:
        unit: the arrays of the unit, with the counts and the kept runs.
        job: an array ``JOB``; it tells the number of edges.
        robot: an array ``ROBOT``, the state of the compiled Algorithm 1, with the counts of events.
    """
    darts, kept = 2 * int(job.gluing.edges), unit.kept
    table = enumerate(unit.counts.tolist())
    return Sums(
        tuple(Counts(n, *row) for n, row in table if row[runs.WORLDS]),
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
    """New arrays for the compiled judge of a unit: the request is filled in, the results are empty.

    The request consists of ``prefix``, the first decisions of the unit's maps, and of a copy of the
    bounds and the budgets in ``level``.  There is room for ``keep`` runs that break a law.
    """
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
    """Empty rows: for the most expensive run of each n, and for ``keep`` runs that break a law.

    ``edges`` is the number of edges of the worlds.
    """
    width = 3 + 8 * edges
    most_expensive, least = (zeros((many, width), int64) for many in (edges + 2, keep))
    return Kept(most_expensive, least, zeros(width, int64))


def compile_apart(explorer: str) -> None:
    """Let another process compile an explorer into the cache, and wait for that process.

    ``explorer`` is the name of a built-in explorer.  Without a writable cache this has no effect.
    """
    in_another_process(f"from {__name__} import explorer_addresses as a; a({explorer!r})").wait()


def in_another_process(code: str) -> subprocess.Popen[bytes]:
    """A new Python process that executes the text ``code``, with the import path of this process.

    The prints of the new process are dropped.
    """
    program = f"import json, sys; sys.path[:] = json.loads(sys.argv[1]); {code}"
    command, no = [sys.executable, "-c", program, json.dumps(sys.path)], subprocess.DEVNULL
    marked = {**os.environ, COMPILER: "1"}
    return subprocess.Popen(command, stdin=no, stdout=no, stderr=no, env=marked)  # noqa: S603  # ours


def set_up(job: Any, robot: Any, level: Level) -> None:
    """Write the request ``level`` into two new arrays.

    ``job`` is an array ``JOB``, the state of the work on a unit; it gets the lighthouse, the laws,
    the sizes and the addresses of the explorer's functions.  ``robot`` is an array ``ROBOT``, the
    state of the compiled Algorithm 1; it gets the policy.
    """
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
    """The run that a row of :class:`Kept` describes; the map of the run has ``darts`` darts."""
    n, *code = row
    return At(n, tuple(code[:darts]), tuple(code[darts : 2 * darts]), code[2 * darts])


def walk(level: Level, prefix: Sequence[int], *, keep: int = 1, halt: Any = None) -> Sums:
    """Walk Algorithm 1 once in every map whose first decisions are ``prefix``.

    Call this function only if the request ``level`` asks for the class ``maps``, the directional
    lighthouse, all laws, and a bound that depends on n alone: the function takes this for granted,
    and does not check it.

    If no walk breaks a law, the counts are those of :func:`judge`.  If a walk breaks a law, the
    result has one broken run for this rooted map, in place of one for each place of the lighthouse;
    this run has no place and names no law.  A walk breaks a law if it fails, if it costs more than
    the bound for its n, or if it costs more than the largest of all numbers in ``level.budgets``.
    The cost of a walk that fails is not counted.

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
    table = w.counts[: edges + 2].tolist()
    return Sums(
        tuple(_walked_counts(n, row, edges, places) for n, row in enumerate(table) if row[0]),
        _walked_events(table, edges, places),
        tuple((n, 0, 0) for n, row in enumerate(table) if row[0]),
        tuple(_at(row, darts) for row in kept.most_expensive.tolist() if row[0]),
        tuple(BrokenRun(*_at(row, darts)[:3], None, "") for row in kept.least.tolist() if row[0]),
    )


def _walked_counts(n: int, row: list[int], edges: int, places: int) -> Counts:
    worlds, cost = row[walks.WORLDS], row[walks.TRAVERSALS]
    of_runs = places * worlds, places * cost, cost, row[walks.LARGEST], places * worlds * edges, 0
    return Counts(n, worlds, *of_runs, *row[walks.LOOP_EDGE : walks.FAILURES])


def _walked_events(table: list[list[int]], edges: int, places: int) -> dict[str, int]:
    counted = [walks.CASES_1, walks.CASES_2, walks.TESTS_AT_V0, walks.EMPTY_HS]
    case_1, case_2, at_v0, empty = (sum(row[column] for row in table) for column in counted)
    ended = [row[walks.WORLDS] - row[walks.FAILURES] for row in table]
    loops = sum((edges - n + 1) * times for n, times in enumerate(ended))
    others = sum((n - 1) * times for n, times in enumerate(ended))
    events = case_1, case_2, loops, at_v0, empty, loops, others
    return {event: places * times for event, times in zip(EVENTS, events, strict=True)}


def flag() -> Any:
    """An array with the one number 0; threads give up their work once the number is not 0."""
    return zeros(1, int64)


class LaidOutRuns(Struct, frozen=True):
    """A batch of runs whose worlds have been written to memory for a player.

    The runs of a unit are numbered from 0 on; a world without a place also has a number.

    Attributes:
        runs: how many runs the batch has.
        first: the number of the batch's first run in the unit.
        until: the number of the run after the batch's last run.
        last: whether this batch is the last batch of its unit.
    """

    runs: int
    first: int
    until: int
    last: bool


class UnitJudge:
    """The compiled judge of the runs of a unit; other processes play these runs, batch by batch.

    Args:
        level: the request: the number of edges, the lighthouse and the rules.
        prefix: the first decisions by which each map of the unit is made.
        keep: the largest number of runs of a batch that break a law and are kept.
        stretch: the memory of the first play of a batch, in which the explorer walks in worlds.
        replay: the memory of the second play, in which the explorer gets the percepts of the first
            play.
    """

    def __init__(
        self, level: Level, prefix: Sequence[int], keep: int, stretch: Stretch, replay: Stretch
    ) -> None:
        self._stretch, self._replay, self.worlds, self.noted = stretch, replay, stretch.worlds, 0
        self._ahead, self._job, self._robot = new(JOB), new(JOB), new(ROBOT)
        for job in (self._ahead, self._job):
            set_up(job, self._robot, level)
        self._unit = unit_of(level, prefix, keep)
        self._reader = reader = new(READER)
        reader.logs, reader.begins = stretch.logs.ctypes.data, stretch.begins.ctypes.data
        reader.percepts, reader.starts = replay.percepts.ctypes.data, replay.starts.ctypes.data

    def lay_out(self, most: int) -> LaidOutRuns:
        """Write the next batch, of about ``most`` runs, to memory; return a description of it."""
        ahead, stretch = self._ahead, self._stretch
        first = int(ahead.number)
        ahead.until = first + min(most, layout.LONGEST_STRETCH)
        placed = lay_out(ahead, self._unit, stretch.heads, stretch.worlds)
        self.heads = stretch.heads[:placed].copy()
        return LaidOutRuns(placed, first, int(ahead.number), int(ahead.until) == 0)

    def judge(self, batch: LaidOutRuns, size: int) -> tuple[Sums, bool]:
        """Judge the logs in memory; return the results, and whether they are valid.

        The results are not valid if only the Python judge can judge some log, for example because
        the log holds an unusual entry; if the percepts do not fit into memory; or if the bound has
        no value in a world.

        The percepts of the batch's runs are written to the memory of the second play.

        Args:
            batch: the batch whose logs are in memory.
            size: the size of these logs in bytes.
        """
        reader, job, unit, count = self._reader, self._job, self._unit, batch.runs
        reader.size = max(0, min(size, LOG_BYTES))
        reader.noted = reader.run = reader.strange = 0
        job.until = batch.until
        for results in (unit.met, unit.counts, unit.kept.most_expensive, unit.kept.least):
            results[:] = 0
        runs.examine(job, reader, unit, flag())
        starts, heads = self._replay.starts, self._replay.heads[:count]
        starts[count] = self.noted = int(reader.noted)
        self.heads[:, layout.RUN_MOTIONS] = (starts[1 : count + 1] - starts[:count]) // 3 - 1
        heads[:] = self.heads
        # The second player must not know which runs these are.
        heads[:, layout.RUN_NUMBER : layout.RUN_MOTIONS] = 0
        good = reader.run == count and reader.strange == 0 and job.undefined == 0
        sums = sums_of(unit, job, self._robot)
        return sums, good


@entry
def lay_out(job, unit, heads, worlds):
    """Write the next runs of a unit to memory; return the number of the written runs.

    The function makes one map of the unit after the other, and writes all runs in each map.  It
    goes on until at least one run is written.  From then on it makes a further map only if two
    conditions hold: ``job.number``, the number of the next run, is less than ``job.until``; and
    there is surely room for all runs in the further map.

    ``job`` and ``unit`` are the arguments of :func:`allworlds.engines.kernel.runs.examine`.  After
    the last run of the unit ``job.until`` becomes 0; in later calls nothing is written.

    Each run is written to a row of ``heads`` and a row of ``worlds``.  A row of ``heads`` holds the
    budget, the number that the explorer is told, the number of the run, and the number of the
    place.  A row of ``worlds`` holds five numbers for each dart: the first dart of its vertex, the
    other dart of its edge, and the three numbers of the percept on arriving by the dart.
    """
    g, world, placed = job.gluing, job.world, 0
    room = len(heads) - 2 * layout.MOST_PLACES
    while job.until and (placed == 0 or (job.number < job.until and placed <= room)):
        if not advance(g, unit.prefix, unit.viable):
            job.until = 0
            break
        settle(world, g)
        call(job.lighthouse, (world,))
        if world.place == NONE:
            job.number += 1
        while world.place != NONE:
            head, row = heads[placed], worlds[placed]
            head[layout.RUN_BUDGET] = unit.budgets[world.vertices]
            head[layout.RUN_TOLD], head[layout.RUN_NUMBER] = world.told, job.number
            head[layout.RUN_PLACE] = world.place
            for dart in range(world.darts):
                at = layout.WIDE * dart
                row[at + layout.FIRST] = world.first[dart]
                row[at + layout.PARTNER] = world.alpha[dart]
                row[at + layout.DEGREE] = world.degree[dart]
                row[at + layout.MARKS] = world.marks[dart]
                row[at + layout.BEARING] = world.bearing[dart] + 1
            placed += 1
            job.number += 1
            call(job.lighthouse, (world,))
    return placed
