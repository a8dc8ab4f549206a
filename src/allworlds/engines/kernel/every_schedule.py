"""Every schedule of every run of a unit, by its logs: judged, tallied, and none left out.

The logs of a run follow each other in the order of the scripts of their choices.  A script is the
answers to the first choices of an episode; the answers to all others are 0.  Behind each log
stand the choices that were made: their number in two bytes, and for each what was picked and the
number of options.

A run's logs may come in several portions, and the judge goes on where it stopped.  The twin is
:class:`allworlds.protocol.Schedules`.
"""

from __future__ import annotations

from numpy import int64

from allworlds.engines.kernel.calls import byte_of, call_with, entry_of, put_entry
from allworlds.engines.kernel.capabilities import MOST_PICKS
from allworlds.engines.kernel.compiling import entry, inlined
from allworlds.engines.kernel.gluing import advance
from allworlds.engines.kernel.records import NONE
from allworlds.engines.kernel.runs import (
    LEFT_OUT,
    RUNS,
    UNDEFINED,
    blame,
    bound_of,
    count_run,
    count_world,
    judged_run,
)
from allworlds.engines.kernel.stretch import (
    RUN_BUDGET,
    RUN_MOTIONS,
    RUN_NUMBER,
    RUN_SCRIPT,
    RUN_TOLD,
)
from allworlds.engines.kernel.worlds import settle

# The stages of the judge.
BETWEEN_RUNS, BEFORE_A_RUN, INSIDE_A_RUN = range(3)

ROW_BITS = 20
"""The bits of the number of a log, which stand behind the place of a run that breaks a law."""


@entry
def examine_schedules(
    job,
    reader,
    now,
    prefix,
    viable,
    bounds,
    met,
    budgets,
    counts,
    most_expensive,
    least,
    row,
    beat,
    heads,
    dearest,
    best,
):
    """Examine the next logs, at most as many as there are ``heads``.

    Work ends early where the choices of a log are not those that are due, or where the percepts
    might have no room.  A run is counted with its first log, and a world with its first run.

    ``reader`` has the logs, without where each begins; ``now`` is where the judge is; ``prefix`` to
    ``beat`` are as for :func:`allworlds.engines.kernel.runs.examine`, but that behind the place in
    ``least`` stands the number of the log.  Of each log ``heads`` becomes what is said of its run,
    with the lengths of its walk and its script.  By vertices ``dearest`` becomes the number of the
    log that costs most, and ``best`` the largest cost of the cheapest schedule of a run that is
    done.
    """
    world, at = job.world, int64(0)
    while reader.run < len(heads):
        if now.stage == BETWEEN_RUNS and not _next_run(job, now, prefix, viable, counts):
            return
        n = world.vertices
        full = reader.noted + 3 * (budgets[n] + 1) + MOST_PICKS + 4 > reader.room
        if at >= reader.size or (full and reader.run):
            return
        bound = bound_of(world, bounds, met)
        if bound == UNDEFINED:
            job.undefined = 1
            return
        if now.stage == BEFORE_A_RUN:
            if world.place == 0:
                count_world(world, counts)
            counts[n, RUNS] += 1
            now.stage, now.due, now.cheapest = INSIDE_A_RUN, 0, budgets[n]
        episode = reader.run
        put_entry(reader.begins, episode, at)
        law = judged_run(job, reader, budgets[n], bound, beat)
        cost = job.log.cost
        _note_head(world, job, heads[episode], budgets[n], now.due)
        _note_script(reader, now)
        at = _behind_the_choices(reader, entry_of(reader.ends, episode), now)
        if at < 0:
            reader.strange += 1
            return
        put_entry(reader.ends, episode, at)
        if count_run(world, cost, job.log.checkpoints, law, counts, most_expensive):
            dearest[n] = episode
        if law:
            blame(world, world.place << ROW_BITS | episode, law, least, row)
        now.cheapest = min(now.cheapest, cost)
        if now.due == 0:
            best[n] = max(best[n], now.cheapest)
            _leave(job, now)


@inlined
def _next_run(job, now, prefix, viable, counts):
    """Go to the next run, in the next world that has a place; return whether there is one."""
    world = job.world
    while job.number < job.until and advance(job.gluing, prefix, viable):
        settle(world, job.gluing)
        call_with(job.lighthouse, world)
        if world.place != NONE:
            now.stage = BEFORE_A_RUN
            return True
        count_world(world, counts)
        counts[world.vertices, LEFT_OUT] += 1
        job.number += 1
    return False


@inlined
def _leave(job, now):
    """Leave a run, for the next place in its world if there is one."""
    job.number += 1
    now.done += 1
    call_with(job.lighthouse, job.world)
    now.stage = BETWEEN_RUNS if job.world.place == NONE else BEFORE_A_RUN


@entry
def leave_out(job, now, prefix, viable, counts):
    """Go on behind the runs up to ``job.until``, which are judged elsewhere."""
    while now.stage != BETWEEN_RUNS or _next_run(job, now, prefix, viable, counts):
        _leave(job, now)


@inlined
def _note_head(world, job, head, budget, script):
    """Write what is said of the run besides its percepts."""
    head[RUN_BUDGET], head[RUN_TOLD], head[RUN_NUMBER] = budget, world.told, job.number
    head[RUN_MOTIONS], head[RUN_SCRIPT] = job.log.cost, script


@inlined
def _note_script(reader, now):
    """Note the script behind the percepts of the run: a byte each, and three without meaning."""
    noted = reader.noted
    if noted + now.due + 4 > reader.room:
        reader.strange += 1
        return
    for turn in range(now.due):
        put_entry(reader.percepts + noted + turn, 0, now.script[turn])
    reader.noted = noted + now.due


@inlined
def _behind_the_choices(reader, at, now):
    """The place behind the choices; -1 if they are not those that are due.

    The script becomes that of the next schedule, and is empty behind the last one.
    """
    logs, size, due = reader.logs, reader.size, now.due
    turns = int64(MOST_PICKS + 1)
    if at + 2 <= size:
        turns = byte_of(logs, at) | byte_of(logs, at + 1) << 8
    at += 2
    if turns > MOST_PICKS or turns < due or at + 2 * turns > size:
        return int64(-1)
    after = 0
    for turn in range(turns):
        picked, width = byte_of(logs, at), byte_of(logs, at + 1)
        if turn < due:
            fits = picked == now.script[turn] and width == now.widths[turn]
        else:
            fits = picked == 0
        if not fits or picked >= width:
            return int64(-1)
        now.script[turn], now.widths[turn] = picked, width
        if picked + 1 < width:
            after = turn + 1
        at += 2
    if after:
        now.script[after - 1] += 1
    now.due = after
    return at
