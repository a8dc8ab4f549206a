"""Every run of a unit, played, judged and tallied: the loop of the compiled judge.

A run is a world with a place of the lighthouse.  Runs are numbered within their unit as those
of the Python engine are: a world without a place counts as one.
"""

from __future__ import annotations

from allworlds.engines.kernel.answers import answer_law
from allworlds.engines.kernel.calls import call_with
from allworlds.engines.kernel.code import (
    encode,
    encode_unrooted,
    is_greater,
    is_less,
    keep_least_of_kind,
)
from allworlds.engines.kernel.compiling import entry, inlined, inner
from allworlds.engines.kernel.explorers import play
from allworlds.engines.kernel.folding import folds
from allworlds.engines.kernel.gluing import advance
from allworlds.engines.kernel.invariants import variant_at_the_end
from allworlds.engines.kernel.law_numbers import (
    BOUND,
    FOLDING,
    INVARIANT_1,
    INVARIANT_2,
    NO_ESTIMATE,
    VARIANT,
)
from allworlds.engines.kernel.records import NONE
from allworlds.engines.kernel.worlds import doubled, settle

# The columns of the tally, by vertices.
(
    WORLDS,
    RUNS,
    TRAVERSALS,
    TRAVERSALS_ROOTED,
    LARGEST,
    CHECKPOINTS,
    LEFT_OUT,
    LOOP_EDGE,
    PARALLEL_EDGE,
) = range(9)
COLUMNS = 9

# The columns of a listed run.
LAW, COST, SHOWN, WALK = range(4)
LISTED = 4

# What a bound is worth that has no value for some sizes.
UNDEFINED = -(1 << 62)


@entry
def examine(
    job,
    explorer,
    prefix,
    viable,
    bounds,
    met,
    budgets,
    counts,
    most_expensive,
    least,
    row,
    listed,
    beat,
    halt,
):
    """Examine a unit; return whether it is done, else it was given up or reached ``job.until``.

    Args:
        job: a new record with the request filled in.
        explorer: behind its C interface, or a log that is read again.
        prefix: the decisions that the gluing of each map of the unit begins with.
        viable: by darts owed and darts open after a decision: a map can still be finished.
        bounds: the largest legal cost by vertices, degree of v0 and largest degree; the latter
            two have one entry where the bound does not depend on them.
        met: of the same shape; 1 where there was a run.
        budgets: the largest number of traversals, by vertices.
        counts: the tally, added to.
        most_expensive: by vertices, the least of the runs that cost most, as the rows of ``least``.
        least: the least runs that break a law, as rows: vertices, canonical code, place, law.
        row: room for one of these.
        listed: each run while there is room for its number.
        beat: the number of the current run, and the explorer's turns in it.
        halt: ``halt[0]`` is not 0 once the work is to be given up.
    """
    g, world = job.gluing, job.world
    while halt[0] == 0 and job.number < job.until:
        if not advance(g, prefix, viable):
            return True
        settle(world, g)
        n = world.vertices
        _count_world(world, counts)
        call_with(job.lighthouse, world)
        if world.place == NONE:
            counts[n, LEFT_OUT] += 1
            job.number += 1
        while world.place != NONE:
            counts[n, RUNS] += 1
            beat[0] = job.number
            bound = _bound_of(world, bounds, met)
            if bound == UNDEFINED:
                job.undefined = 1
                return True
            law = _judged_run(job, explorer, budgets[n], bound, beat)
            _count_run(world, job.log.cost, job.log.checkpoints, law, counts, most_expensive)
            if law:
                _blame(world, law, least, row)
            if job.number < len(listed):
                _list(world, job.log, law, job.number, listed)
            job.number += 1
            call_with(job.lighthouse, world)
    return False


@inlined
def _count_world(world, counts):
    """Add a world to the tally."""
    n, kinds = world.vertices, doubled(world)
    counts[n, WORLDS] += 1
    counts[n, LOOP_EDGE] += kinds & 1
    counts[n, PARALLEL_EDGE] += kinds >> 1


@inlined
def _bound_of(world, bounds, met):
    """The largest legal cost of this run, which is noted as met; UNDEFINED if it has no value."""
    n, d0, largest = world.vertices, 0, 0
    if bounds.shape[1] > 1:
        d0 = world.degree[0]
    if bounds.shape[2] > 1:
        for dart in range(world.darts):
            largest = max(largest, world.degree[dart])
    met[n, d0, largest] = 1
    return bounds[n, d0, largest]


@inner
def _judged_run(job, explorer, budget, bound, beat):
    """Play and judge a run; return the first law that it breaks, or 0."""
    world, log, judged = job.world, job.log, job.judged
    judged.broken = judged.shown = judged.known = 0
    law = play(world, explorer, budget, beat, log, judged)
    beat[1] = 0
    if law:
        return law
    laws = job.laws
    law = answer_law(log.published, world, log.dart, judged)
    if law == NO_ESTIMATE or (law and laws >> law & 1):
        return law
    variant_at_the_end(judged)
    broken = judged.broken & laws
    if broken:
        for law in (INVARIANT_1, INVARIANT_2, VARIANT):
            if broken >> law & 1:
                return law
    if laws >> FOLDING & 1 and not folds(world, log, job.fold):
        return FOLDING
    if laws >> BOUND & 1 and log.cost > bound:
        return BOUND
    return 0


@inlined
def _count_run(world, cost, checkpoints, law, counts, most_expensive):
    """Add a run to the tally; note it if it is the most expensive so far."""
    n = world.vertices
    more_expensive = cost > counts[n, LARGEST]
    if more_expensive or (cost == counts[n, LARGEST] and is_less(world, most_expensive, n)):
        _note(world, law, most_expensive[n])
    counts[n, TRAVERSALS] += cost
    if world.place == 0:
        counts[n, TRAVERSALS_ROOTED] += cost
    counts[n, LARGEST] = max(counts[n, LARGEST], cost)
    counts[n, CHECKPOINTS] += checkpoints


@inner
def _note(world, law, row):
    """Write a run as a row, but for its map's code without a root."""
    row[0] = world.vertices
    encode(world, 0, row, 1)
    row[1 + 2 * world.darts] = world.place
    row[2 + 2 * world.darts] = law


@inner
def _blame(world, law, least, row):
    """Keep a run that breaks a law, if it is among the least."""
    _note(world, law, row)
    if not is_greater(least, row):
        encode_unrooted(world, row, 3 + 2 * world.darts)
        keep_least_of_kind(least, row, 2 + 2 * world.darts)


@inner
def _list(world, log, law, number, listed):
    """List the run: law, cost, checkpoints, and a hash of its whole walk."""
    walk, before = 0, world.start
    for step in range(log.cost):
        dart = log.arrived[step]
        motion = world.spot[world.alpha[dart]] - world.spot[before]
        if motion < 0:
            motion += world.degree[before]
        before = dart
        for part in (motion, world.degree[dart], world.marks[dart], world.bearing[dart]):
            walk = (walk * 31 + part + 1) % 2147483647
    listed[number, LAW], listed[number, COST] = law, log.cost
    listed[number, SHOWN], listed[number, WALK] = log.checkpoints, walk
