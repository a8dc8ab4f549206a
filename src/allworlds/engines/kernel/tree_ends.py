"""Runs of a tree at their ends: counted, or kept to be played again.

Where a run ends with all of its world decided, all laws kept and the right answer, it is counted.
Every other run is left to the judge of single runs (:mod:`allworlds.engines.kernel.runs`), with the
bytes of its log: so it alone says which law is broken.  If a run ends before all of the world is
decided, that is done for every way to finish the world.
"""

from __future__ import annotations

from numpy import int64

from allworlds.engines.kernel.answers import answer_law
from allworlds.engines.kernel.bits import lowest
from allworlds.engines.kernel.calls import address_of, copy, put_entry
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.embedding import grown
from allworlds.engines.kernel.invariants import variant_at_the_end
from allworlds.engines.kernel.law_numbers import BOUND, FOLDING
from allworlds.engines.kernel.log_codes import (
    ANSWERED,
    LARGEST_MOTION,
    SHOWN,
)
from allworlds.engines.kernel.logs import percept_of, span
from allworlds.engines.kernel.on_demand import (
    NOWHERE,
    decide,
    decide_again,
)
from allworlds.engines.kernel.records import DARTS
from allworlds.engines.kernel.runs import (
    RUNS,
    UNDEFINED,
    blame,
    bound_of,
    count_run,
    count_world,
    judged_run,
)
from allworlds.engines.kernel.tree_records import PATH_BYTES
from allworlds.engines.kernel.worlds import arrival

# The columns of a run that is kept: bytes of log and percepts, traversals, place, then its world.
BYTES, SENSED, COST, PLACE, SIGMA = range(5)
ALPHA = SIGMA + DARTS
HEAD = ALPHA + DARTS


@inner
def gather(h, logs):
    """Copy the log of the run, which has ended, to one place."""
    h.bytes = 0
    for part in range(h.demand.ways + 1):
        begin, length = h.begins[part], h.ends[part] - h.begins[part]
        if h.bytes + length > PATH_BYTES:
            h.strange = 1
            return
        for i in range(length):
            h.log[h.bytes + i] = logs[begin + i]
        h.bytes += length


@inlined
def repeats(h, logs, before):
    """Whether the log of this run is the one that was read before."""
    gather(h, logs)
    same = h.bytes == len(before) and not h.strange
    for i in range(min(h.bytes, len(before))):
        same = same and h.log[i] == before[i]
    return same


@inlined
def keep(h, logs, kept, head):
    """Keep the run, if there is room for it; its world must have been decided."""
    d, world = h.demand, h.demand.world
    gather(h, logs)
    head[BYTES] = 0
    sensed = 3 * (d.cost + 1)
    if not d.whole or h.bytes + sensed + 1 > len(kept):
        return
    head[BYTES], head[SENSED], head[COST], head[PLACE] = h.bytes, sensed, d.cost, d.place
    for dart in range(world.darts):
        head[SIGMA + dart], head[ALPHA + dart] = world.sigma[dart], world.alpha[dart]
    at = h.bytes
    dart, i = 0, 0
    while True:
        put_entry(address_of(kept) + at, 0, percept_of(world, dart))
        at += 3
        while i < h.bytes and h.log[i] == SHOWN:
            i += 3 + span(int64(h.log[i + 1]))
        if i >= h.bytes or h.log[i] > LARGEST_MOTION or at >= h.bytes + sensed:
            break
        dart = arrival(world, dart, int64(h.log[i]))
        i += 1
    for i in range(h.bytes):
        kept[i] = h.log[i]


@inlined
def count(
    h,
    job,
    reader,
    viable,
    budgets,
    bounds,
    met,
    counts,
    most_expensive,
    least,
    row,
    beat,
    logs,
    code,
):
    """Count a run: in the world that is decided, or in all worlds that it may be."""
    d, world, judged = h.demand, h.demand.world, h.judged
    if d.whole and code == ANSWERED:
        n = d.gluing.vertices
        world.vertices = n
        bound = bound_of(world, bounds, met)
        if bound == UNDEFINED:
            h.undefined = 1
            return
        variant_at_the_end(judged)
        folded = h.fold.open == 0 or not job.laws >> FOLDING & 1
        cheap = d.cost <= bound or not job.laws >> BOUND & 1
        if judged.broken == 0 and folded and cheap and _is_answered(h, job):
            counts[n, RUNS] += 1
            if d.place == 0:
                count_world(world, counts)
            count_run(world, d.cost, d.shown, int64(0), counts, most_expensive)
            return
    gather(h, logs)
    if h.strange:
        return
    base, going = d.depth, True
    while going:
        while d.gluing.open and decide(d, lowest(d.gluing.open), viable, budgets) != NOWHERE:
            pass
        if not d.gluing.open:
            _count_single(
                h, job, reader, budgets, bounds, met, counts, most_expensive, least, row, beat
            )
            if h.strange or h.undefined:
                return
        going = False
        while d.depth > base and not going:
            going = decide_again(d, viable, budgets) != NOWHERE


@inlined
def _is_answered(h, job):
    """Whether the answer is right."""
    world, published = h.demand.world, job.log.published
    if grown(h.judged, published, world, h.dart, -1) and h.judged.explored == world.darts:
        return True
    # The room of the other judge: this one still needs its embedding.
    job.judged.known = 0
    return answer_law(published, world, h.dart, job.judged) == 0


@inner
def _count_single(h, job, reader, budgets, bounds, met, counts, most_expensive, least, row, beat):
    """Let the judge of single runs judge and count the run, in the world that is decided."""
    d = h.demand
    world = job.world
    d.world.vertices = n = d.gluing.vertices
    copy(world, d.world)
    bound = bound_of(world, bounds, met)
    if bound == UNDEFINED:
        h.undefined = 1
        return
    reader.logs, reader.size = address_of(h.log), h.bytes
    reader.run = reader.noted = reader.strange = 0
    law = judged_run(job, reader, budgets[0, n], bound, beat)
    if reader.strange:
        h.strange = 1
        return
    counts[n, RUNS] += 1
    if world.place == 0:
        count_world(world, counts)
    count_run(world, job.log.cost, job.log.checkpoints, law, counts, most_expensive)
    if law:
        blame(world, world.place, law, least, row)
