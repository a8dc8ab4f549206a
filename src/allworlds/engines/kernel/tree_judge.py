"""The judge of a tree of runs: its log is followed, and what several runs have in common, once.

The world is decided as the first player has decided it (:mod:`allworlds.engines.kernel.on_demand`).
On the way the log is folded, and checkpoints are looked at; at a branch the state of both is kept.
What becomes of a run at its end is in :mod:`allworlds.engines.kernel.tree_ends`.
"""

from __future__ import annotations

from numpy import int64

from allworlds.engines.kernel.bits import lowest
from allworlds.engines.kernel.calls import address_of, copy_bytes, put_entry, word_of
from allworlds.engines.kernel.compiling import entry, inlined, inner
from allworlds.engines.kernel.folding import begin_fold, fold_step, unfold
from allworlds.engines.kernel.invariants import look_at
from allworlds.engines.kernel.log_codes import (
    ANSWERED,
    ILLEGAL,
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
from allworlds.engines.kernel.tree_ends import count, gather, keep, repeats
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


@entry
def judge_tree(
    h,
    job,
    reader,
    prefix,
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
    last,
    before,
    segments,
    percepts,
    stops,
    samples,
    kept,
    heads,
):
    """Judge a chunk of a tree, and cut it into segments for the second play.

    ``h.strange`` is not 0 if it is no chunk, or only another engine can judge it; the tallies are
    void then.  The next chunk begins at ``h.demand.place`` with the first ``h.demand.ways`` ways
    of the path there.

    ``h`` has the request filled in, as for :func:`allworlds.engines.kernel.tree_player.play_tree`,
    ``job`` that of the judge of single runs, to which ``reader`` reads; ``prefix`` to ``budgets``
    are as for ``play_tree``, and ``bounds`` to ``row`` as for
    :func:`allworlds.engines.kernel.runs.examine`.  ``beat`` is room for a heartbeat.  ``logs`` are
    the bytes of the chunk, with slack behind them; ``last``: the tree of the unit ends with it.
    ``before`` is the log of the run that is repeated, empty where a tree begins.

    Written are ``segments``, ``percepts`` and, in ``stops``, where the log of each run ends.  The
    runs whose numbers are the ``samples``, ascending and -1 at the end, are written to rows of
    ``kept``, log and percepts in bytes, and of ``heads``, with the columns above.
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
                h.strange = not repeats(h, logs, before)
            else:
                if h.runs == samples[sampled]:
                    keep(h, logs, kept[sampled], heads[sampled])
                    sampled += 1
                stops[h.runs] = at
                h.runs += 1
                ways = d.ways
                count(
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
                )
                d.ways = ways
            if h.strange or h.undefined:
                return
            if at == size and not last:
                gather(h, logs)
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
