"""The judge of a tree of runs: its log is followed, and what several runs have in common, once.

The world is decided as the first player has decided it (:mod:`allworlds.engines.kernel.on_demand`).
On the way the log is folded, and checkpoints are looked at; at a branch the state of both is kept.
Where a run ends with all of its world decided, all laws kept and the right answer, it is counted.
Every other run is left to the judge of single runs (:mod:`allworlds.engines.kernel.runs`), with the
bytes of its log: so it alone says which law is broken.  If a run ends before all of the world is
decided, that is done for every way to finish the world.
"""

from __future__ import annotations

from numpy import int64

from allworlds.engines.kernel.answers import answer_law
from allworlds.engines.kernel.bits import lowest
from allworlds.engines.kernel.calls import address_of, copy, copy_bytes, put_entry, word_of
from allworlds.engines.kernel.compiling import entry, inlined, inner
from allworlds.engines.kernel.embedding import grown
from allworlds.engines.kernel.folding import begin_fold, fold_step, unfold
from allworlds.engines.kernel.invariants import look_at, variant_at_the_end
from allworlds.engines.kernel.law_numbers import BOUND, FOLDING
from allworlds.engines.kernel.log_codes import (
    ANSWERED,
    ILLEGAL,
    LARGEST_MOTION,
    MOST_PUBLISHED,
    OVER_BUDGET,
    SHOWN,
    SHOWN_TOO_OFTEN,
)
from allworlds.engines.kernel.logs import percept_of, span
from allworlds.engines.kernel.on_demand import (
    NOWHERE,
    SEVERAL,
    begin,
    decide,
    decide_again,
    places,
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
from allworlds.engines.kernel.worlds import arrival
from allworlds.engines.kernel.tree_records import PATH_BYTES
from allworlds.engines.kernel.tree_requests import (
    AT,
    DEAD_END,
    END_OF_RUN,
    INSIDE,
    LAST,
    MOTIONS,
    NEXT,
    PERCEPTS,
)

ROOM = 512
"""Bytes that are free behind a log, and in that of a run before each action."""

# The columns of a run that is kept: bytes of log and percepts, traversals, place, then its world.
BYTES, SENSED, COST, PLACE, SIGMA = range(5)
ALPHA = SIGMA + DARTS
HEAD = ALPHA + DARTS


@entry
def judge_tree(
    h, job, reader, prefix, viable, budgets, bounds, met, counts, most_expensive, least, row, beat,
    logs, last, before, segments, percepts, stops, samples, kept, heads,
):  # fmt: skip
    """Judge a chunk of a tree, and cut it into segments for the second play.

    ``h.strange`` is not 0 if it is no chunk, or only another engine can judge it; the tallies are
    void then.  The next chunk begins at ``h.demand.place`` with the first ``h.demand.ways`` of the path
    there.

    Args:
        h: with the request filled in, as for :func:`allworlds.engines.kernel.tree_player.play_tree`.
        job: the judge of single runs, with the request filled in.
        reader: reads the log of a run for it.
        prefix: as for ``play_tree``, and so are ``viable`` and ``budgets``.
        bounds: as for :func:`allworlds.engines.kernel.runs.examine`, and so are the arguments up
            to ``row``.
        beat: room for a heartbeat.
        logs: the bytes of the chunk, and slack behind them.
        last: whether the tree of the unit ends with the chunk; it is strange if not.
        before: the bytes of the log of the run that is repeated; empty if the tree begins.
        segments: is written.
        percepts: is written.
        stops: is written: where the log of each run ends.
        samples: the numbers of runs in this chunk that are kept, ascending; ends with -1.
        kept, heads: a row for each of them: percepts and log in bytes; and the columns below.
    """
    d = h.demand
    size, at, sampled, resumed = len(logs) - ROOM, int64(0), 0, len(before) > 0
    h.runs = h.segments = h.noted = h.rooted = h.strange = h.undefined = 0
    _begin(h, prefix, budgets, segments, percepts, at)
    while True:
        full = h.runs == len(stops) or h.segments + 1 >= len(segments)
        if full or at >= size or h.noted + 4 > len(percepts):
            h.strange = 1
            return
        code = int64(logs[at])
        at += 1
        if code < d.world.degree[h.dart] and d.cost < d.budget:
            if _move(h, code, viable, budgets, segments, percepts, at):
                continue
        elif code == SHOWN and d.shown <= d.budget:
            at = _look(h, job.log.published, reader, logs, at)
            if h.strange:
                return
            continue
        else:
            at = _end(h, job.log.published, reader, logs, at, code)
            if h.strange:
                return
            _close(h, segments, END_OF_RUN)
            h.ends[d.ways] = at
            if resumed:
                resumed = False
                d.given = 0
                h.strange = not _repeats(h, logs, before)
            else:
                if h.runs == samples[sampled]:
                    _keep(h, logs, kept[sampled], heads[sampled])
                    sampled += 1
                stops[h.runs] = at
                h.runs += 1
                ways = d.ways
                _count(
                    h, job, reader, viable, budgets, bounds, met, counts, most_expensive, least,
                    row, beat, logs, code,
                )  # fmt: skip
                d.ways = ways
            if h.strange or h.undefined:
                return
            if at == size and not last:
                _gather(h, logs)
                if not d.depth:
                    d.place += 1
                    d.ways = 0
                h.strange = d.place == places(d, prefix)
                return
        if not _go_on(h, viable, budgets, segments, percepts, at):
            d.place += 1
            d.given = d.ways = 0
            if d.place == places(d, prefix):
                h.strange = at != size or not last
                return
            _begin(h, prefix, budgets, segments, percepts, at)


@inlined
def _begin(h, prefix, budgets, segments, percepts, at):
    """Begin a run at the present place."""
    d, judged = h.demand, h.judged
    begin(d, prefix, budgets)
    d.world.darts = 2 * d.gluing.edges
    h.dart = h.walked = 0
    h.begins[0] = at
    judged.broken = judged.shown = judged.known = 0
    begin_fold(d.world, h.fold)
    _open(h, segments, at)
    segments[h.segment, NEXT] = LAST
    h.roots[h.rooted] = h.segment
    h.rooted += 1
    _sense(h, percepts)


@inlined
def _move(h, motion, viable, budgets, segments, percepts, at):
    """Follow a motion; return whether there is a world that goes on so."""
    d, world = h.demand, h.demand.world
    y = h.dart + motion
    if y >= world.first[h.dart] + world.degree[h.dart]:
        y -= world.degree[h.dart]
    if d.gluing.open >> y & 1:
        ways = d.ways
        way = decide(d, y, viable, budgets)
        if way == NOWHERE:
            _close(h, segments, DEAD_END)
            return False
        if d.ways > ways:
            h.ends[ways] = h.begins[d.ways] = at
        if way == SEVERAL:
            _close(h, segments, LAST)
            _save(h, h.branches[d.depth - 1])
            _branch_off(h, segments, at)
    _arrive(h, y, percepts)
    return True


@inlined
def _go_on(h, viable, budgets, segments, percepts, at):
    """Go back to the last branch, and on in its next way; return whether there is one."""
    d = h.demand
    while d.depth:
        way = decide_again(d, viable, budgets)
        if way != NOWHERE:
            branch = d.depth - (way == SEVERAL)
            _restore(h, h.branches[branch])
            h.begins[d.ways] = at
            _branch_off(h, segments, at)
            _arrive(h, d.branches[branch].y, percepts)
            return True
    return False


@inlined
def _arrive(h, y, percepts):
    """Let the robot arrive behind the dart, which has been decided."""
    d, world, fold = h.demand, h.demand.world, h.fold
    d.cost += 1
    h.dart = world.alpha[y]
    h.walked |= 1 << y | 1 << h.dart
    if fold.open:
        fold_step(world, fold, h.dart)
    _sense(h, percepts)


@inner
def _sense(h, percepts):
    """Note the robot's percept."""
    put_entry(address_of(percepts) + h.noted, 0, percept_of(h.demand.world, h.dart))
    h.noted += 3


@inlined
def _save(h, branch):
    """Note the run up to a branch."""
    fold, judged = h.fold, h.judged
    branch.dart, branch.walked = h.dart, h.walked
    branch.segment = h.segment
    branch.open, branch.node = fold.open, fold.node
    branch.nodes, branch.changes = fold.nodes, fold.changes
    branch.broken, branch.shown, branch.t = judged.broken, judged.shown, judged.t
    branch.known, branch.explored = judged.known, judged.explored
    branch.taken, branch.anew = judged.taken, judged.anew
    copy_bytes(address_of(branch.alpha), address_of(judged.alpha))


@inlined
def _restore(h, branch):
    """Go back to a branch.

    The darts of an S that was embedded there keep their images, unless another S was embedded since
    without an earlier one.
    """
    fold, judged = h.fold, h.judged
    h.dart, h.walked = branch.dart, branch.walked
    h.segment = branch.segment
    unfold(fold, branch.changes)
    fold.open, fold.node, fold.nodes = branch.open, branch.node, branch.nodes
    judged.broken, judged.shown, judged.t = branch.broken, branch.shown, branch.t
    judged.known, judged.explored = branch.known, branch.explored
    judged.taken = branch.taken
    copy_bytes(address_of(judged.alpha), address_of(branch.alpha))
    if judged.anew != branch.anew:
        judged.known = 0


@inner
def _open(h, segments, at):
    """Open a segment whose bytes begin at that place."""
    h.segment = h.segments
    h.segments += 1
    segment = segments[h.segment]
    segment[AT], segment[PERCEPTS] = at, h.noted


@inlined
def _close(h, segments, inside):
    """Close the segment, at a branch or at an end."""
    segment = segments[h.segment]
    ended = inside == END_OF_RUN
    segment[MOTIONS] = (h.noted - segment[PERCEPTS]) // 3 - ended
    segment[INSIDE] = inside


@inner
def _branch_off(h, segments, at):
    """Open a segment behind the branch at the end of this one, at a place that is drawn.

    Source: Marsaglia, Xorshift RNGs (2003), with the shifts 13, 7, 17.
    """
    behind = h.segment
    _open(h, segments, at)
    h.random ^= h.random << 13
    h.random ^= h.random >> 7 & (1 << 57) - 1
    h.random ^= h.random << 17
    first = int64(segments[behind, INSIDE])
    if first == LAST or h.random & 1:
        segments[h.segment, NEXT] = first
        segments[behind, INSIDE] = h.segment
    else:
        segments[h.segment, NEXT] = segments[first, NEXT]
        segments[first, NEXT] = h.segment


@inlined
def _look(h, published, reader, logs, at):
    """Look at a checkpoint; return the place behind it."""
    h.demand.shown += 1
    at = _find_map(h, published, reader, logs, at)
    if not h.strange:
        look_at(h.judged, published, h.demand.world, h.dart, h.walked)
    return at


@inlined
def _end(h, published, reader, logs, at, code):
    """Return the place behind the end of a run."""
    if code == ANSWERED:
        return _find_map(h, published, reader, logs, at)
    h.strange = code != ILLEGAL and code != OVER_BUDGET and code != SHOWN_TOO_OFTEN
    return at


@inner
def _find_map(h, published, reader, logs, at):
    """Find the published map in the log; return the place behind it."""
    darts = int64(logs[at])
    length = 2 + span(darts)
    if darts < 1 or darts > MOST_PUBLISHED or at + length > len(logs) - ROOM:
        h.strange = 1
        return at
    published.darts, published.here = darts, logs[at + 1]
    published.bytes = address_of(logs) + at + 2
    published.sigma, published.alpha = address_of(reader.sigma), address_of(reader.alpha)
    return at + length


@inner
def _gather(h, logs):
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
def _repeats(h, logs, before):
    """Whether the log of this run is the one that was read before."""
    _gather(h, logs)
    same = h.bytes == len(before) and not h.strange
    for i in range(min(h.bytes, len(before))):
        same = same and h.log[i] == before[i]
    return same


@inlined
def _keep(h, logs, kept, head):
    """Keep the run, if there is room for it; its world must have been decided."""
    d, world = h.demand, h.demand.world
    _gather(h, logs)
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
def _count(
    h, job, reader, viable, budgets, bounds, met, counts, most_expensive, least, row, beat, logs,
    code,
):  # fmt: skip
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
    _gather(h, logs)
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
def _count_single(
    h, job, reader, budgets, bounds, met, counts, most_expensive, least, row, beat
):
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
        blame(world, law, least, row)


@entry
def first_difference(one, other, length):
    """The first of so many places at which the bytes differ; ``length`` if there is none.

    Behind both there must be seven bytes more.
    """
    a, b = address_of(one), address_of(other)
    for at in range(0, length, 8):
        differ = word_of(a, at) ^ word_of(b, at)
        if differ:
            return min(length, at + lowest(differ) // 8)
    return length
