"""Every run of a unit, played, judged and counted: the loop of the compiled judge.

A run is a world with a place of the lighthouse.  Runs have the same numbers in their unit as in the
Python engine; a world without a place counts as one run.

In this module a player is one of two things: an explorer behind its C interface; or a reader of
logs, which another process has made by playing an explorer.  The judge is compiled twice: once for
explorers, and once for readers.

Some arguments have the same meaning in all functions.  ``job`` is the state of the unit that is
being done: the map and the lighthouse of the present run, its log, and more.  ``world`` is the map
with its lighthouse.  ``log`` records the walk of the run, and ``judged`` the laws that its
checkpoints break.  ``budget`` is the largest legal number of traversals in the run.
"""

from typing import Any, NamedTuple

from numba import int32
from numba.extending import overload
from numpy import int64

from allworlds import log as codes
from allworlds.engines.kernel import laws
from allworlds.engines.kernel.arrays import LOG_BYTES, NONE, READER, Kept
from allworlds.engines.kernel.capabilities import ANSWER_READY, CHECKPOINT, MOVE
from allworlds.engines.kernel.code import LESS, blame, fingerprint, is_less, note
from allworlds.engines.kernel.compiling import (
    RECORD,
    address_of,
    byte_of,
    call,
    entry,
    entry_of,
    inlined,
    inner,
    put_entry,
)
from allworlds.engines.kernel.laws import answer_law, folds, look_at
from allworlds.engines.kernel.worlds import advance, arrival, doubled, settle

# The columns of the tally, by vertices.
WORLDS, RUNS, TRAVERSALS, TRAVERSALS_ROOTED, LARGEST = range(5)
CHECKPOINTS, LEFT_OUT, LOOP_EDGE, PARALLEL_EDGE, FINGERPRINT = range(5, 10)
COLUMNS = 10

# The entry for sizes for which the bound has no value.
UNDEFINED = -(1 << 62)


class UnitArrays(NamedTuple):
    """The arrays of a unit for :func:`examine`, which reads the request and writes the results.

    The request: ``prefix``, ``viable``, ``bounds`` and ``budgets``.  The results: ``met``,
    ``counts`` and ``kept``.
    """

    # The first decisions of the gluing of each map of the unit.
    prefix: Any
    # By the numbers of owed and open darts after a decision: whether a map can still be finished.
    viable: Any
    # The largest legal cost by vertices, degree of v0 and largest degree; a degree on which the
    # bound does not depend has one entry.  ``met`` is 1 where a run has occurred.
    bounds: Any
    met: Any
    # The largest number of traversals, by vertices; the tally, to which runs are added.
    budgets: Any
    counts: Any
    # The kept runs.
    kept: Kept


@entry
def examine(job, player, unit, halt):
    """Play and judge the runs of a unit; return whether the work on the unit is over.

    The result is True if all runs of the unit are done.  It is also True if the bound has no value
    for a run: then the work ends before this run, and ``job.undefined`` is 1.  The result is False
    if runs are left: because ``halt[0]`` is not 0, or because only the runs before the run number
    ``job.until`` were to be done.

    ``player`` is an explorer, or a reader of logs.  ``unit`` holds the arrays of the unit, to which
    the results are written.
    """
    g, world, counts = job.gluing, job.world, unit.counts
    while halt[0] == 0 and job.number < job.until:
        if not advance(g, unit.prefix, unit.viable):
            return True
        settle(world, g)
        n = world.vertices
        kinds = doubled(world)
        counts[n, WORLDS] += 1
        counts[n, LOOP_EDGE] += kinds & 1
        counts[n, PARALLEL_EDGE] += kinds >> 1
        counts[n, FINGERPRINT] = (counts[n, FINGERPRINT] + fingerprint(world, world.alpha)) & LESS
        call(job.lighthouse, (world,))
        if world.place == NONE:
            counts[n, LEFT_OUT] += 1
            job.number += 1
        while world.place != NONE:
            counts[n, RUNS] += 1
            bound = _bound_of(world, unit.bounds, unit.met)
            if bound == UNDEFINED:
                job.undefined = 1
                return True
            law = _judged_run(job, player, unit.budgets[n], bound)
            _count_run(world, job.log, law, counts, unit.kept.most_expensive)
            if law:
                blame(world, law, unit.kept.least, unit.kept.row)
            job.number += 1
            call(job.lighthouse, (world,))
    return False


@inlined
def _bound_of(world, bounds, met):
    """The largest legal cost of a run in ``world``, or UNDEFINED if the bound has no value.

    ``bounds`` holds the largest legal costs, and ``met`` is 1 where a run has occurred; this run is
    noted there.  Both arrays have three indices: the number of vertices, the degree of v0, and the
    largest degree.  If the bound does not depend on one of these degrees, its index is 0.
    """
    n, d0, largest = world.vertices, 0, 0
    if bounds.shape[1] > 1:
        d0 = world.degree[0]
    if bounds.shape[2] > 1:
        for dart in range(world.darts):
            largest = max(largest, world.degree[dart])
    met[n, d0, largest] = 1
    return bounds[n, d0, largest]


@inlined
def _count_run(world, log, law, counts, most_expensive):
    """Add a run to the counts; if its cost is the largest so far, write it to ``most_expensive``.

    ``most_expensive`` has a row for each number of vertices.  Of several runs with the largest cost
    the run in the map with the least code is written.  ``law`` is the number of the law that the
    run breaks, or 0.
    """
    n, cost = world.vertices, log.cost
    more_expensive = cost > counts[n, LARGEST]
    if more_expensive or (cost == counts[n, LARGEST] and is_less(world, most_expensive, n)):
        note(world, law, most_expensive[n])
    counts[n, TRAVERSALS] += cost
    if world.place == 0:
        counts[n, TRAVERSALS_ROOTED] += cost
    counts[n, LARGEST] = max(counts[n, LARGEST], cost)
    counts[n, CHECKPOINTS] += log.checkpoints


@inner
def _judged_run(job, player, budget, bound):
    """Play and judge a run in ``job.world``; return the number of the broken law, or 0.

    If the run breaks several laws, the number is that of the first law in the order of precedence.
    A run with more than ``budget`` traversals is ended, and breaks the law budget.  ``bound`` is
    the largest legal cost of a run with an answer.
    """
    world, log, judged = job.world, job.log, job.judged
    judged.broken = judged.shown = 0
    law = play(world, player, budget, log, judged)
    if law:
        return law
    checked = job.laws
    law = answer_law(log.published, world, log.dart, judged)
    if law == laws.NO_ESTIMATE or (law and checked >> law & 1):
        return law
    if judged.shown and judged.t != 0:
        judged.broken |= 1 << laws.VARIANT
    for law in (laws.INVARIANT_1, laws.INVARIANT_2, laws.VARIANT):
        if judged.broken & checked & 1 << law:
            return law
    if checked >> laws.FOLDING & 1 and not folds(world, log, job.fold):
        return laws.FOLDING
    if checked >> laws.BOUND & 1 and log.cost > bound:
        return laws.BOUND
    return 0


def play(*arguments: Any) -> int:
    """Play a run; return the number of the law that ended the run, or 0 if it has an answer.

    This function is only a name that compiled code calls.  The compiler puts one of two functions
    in its place: :func:`_meet` if the player is an explorer behind its C interface, :func:`_follow`
    if the player is a reader of logs.

    The arguments are a world, a player, the budget, and the arrays for the log and for the
    judgement of the checkpoints.  A run with more than ``budget + 1`` checkpoints breaks the law
    budget.
    """
    raise NotImplementedError


@overload(play, inline="always")
def _play(world, player, budget, log, judged):
    def met(world, player, budget, log, judged):
        return _meet(world, player, budget, log, judged)

    def read(world, player, budget, log, judged):
        return _follow(world, player, budget, log, judged)

    return read if player == RECORD(READER) else met


@inner
def _meet(world, explorer, budget, log, judged):
    """Play a run of an explorer behind its C interface; return what :func:`play` returns."""
    percept, action = explorer.percept, explorer.action
    log.cost = log.checkpoints = log.walked = 0
    dart = 0
    _sense(world, dart, percept)
    action.kind = 0
    call(explorer.start, (explorer.state, percept, int32(world.told), action))
    while True:
        if action.kind == MOVE:
            if log.cost == budget:
                return laws.BUDGET
            motion, degree = action.motion, world.degree[dart]
            if motion < 0 or motion >= degree:
                motion %= degree
            dart = arrival(world, dart, motion)
            _sense(world, dart, percept)
            log.arrived[log.cost] = dart
            log.cost += 1
            log.walked |= 1 << dart | 1 << world.alpha[dart]
        elif action.kind == CHECKPOINT:
            if log.checkpoints > budget:
                return laws.BUDGET
            log.checkpoints += 1
            call(explorer.answer, (explorer.state, log.published))
            look_at(judged, log.published, world, dart, log.walked)
        elif action.kind == ANSWER_READY:
            log.dart = dart
            call(explorer.answer, (explorer.state, log.published))
            return 0
        else:
            return laws.ILLEGAL_ACTION
        action.kind = 0
        call(explorer.step, (explorer.state, percept, action))


@inlined
def _sense(world, dart, percept):
    """Write to ``percept`` the percept of a robot that arrives by the dart ``dart``."""
    percept.degree = world.degree[dart]
    percept.marks = world.marks[dart]
    percept.bearing = world.bearing[dart]


@inner
def _follow(world, reader, budget, log, judged):
    """Follow the next log through the world; return what :func:`play` returns.

    The percepts are noted for the second play.  This function knows motions, choices, checkpoints
    and estimates; and it knows OVER_BUDGET and SHOWN_TOO_OFTEN, two entries that end a run by the
    law budget.  Any other entry, and any misplaced entry, ends the log here, and the function
    returns illegal-action.  This result is provisional: the Python judge later finds the law that
    is really broken, if any.

    The entry FAULT is the player's note that the explorer breaks a law; after it the counts of the
    kernel are valid.  After any other unknown or misplaced entry the log is counted in
    ``reader.strange``; then the Python judge judges the whole batch.
    """
    logs, size, published = reader.logs, reader.size, log.published
    run, noted = reader.run, reader.noted
    reader.run = run + 1
    put_entry(reader.starts, run, noted)
    at = entry_of(reader.begins, run)
    if at < 0:
        at = size
    cost = shown = walked = 0
    dart, law = 0, NONE
    _note(reader, noted, world, dart)
    while law == NONE:
        code = byte_of(logs, at) if at < size else int64(codes.BEYOND)
        at += 1
        if code < world.degree[dart] and cost < budget:
            dart = arrival(world, dart, code)
            noted += 3
            _note(reader, noted, world, dart)
            log.arrived[cost] = dart
            cost += 1
            walked |= 1 << dart | 1 << world.alpha[dart]
        elif code == codes.SHOWN and shown <= budget and _find_map(reader, at, published):
            at += 2 + 2 * published.darts
            shown += 1
            look_at(judged, published, world, dart, walked)
        elif code == codes.ANSWERED and _find_map(reader, at, published):
            at += 2 + 2 * published.darts
            law = 0
        elif code == codes.CHOICE:
            at += 2
        elif (code == codes.OVER_BUDGET and cost == budget) or (
            code == codes.SHOWN_TOO_OFTEN and shown > budget
        ):
            law = laws.BUDGET
        else:
            law = laws.ILLEGAL_ACTION
            reader.strange += code != codes.FAULT
    log.cost, log.checkpoints, log.dart, log.walked = cost, shown, dart, walked
    reader.noted = noted + 3
    return law


@inlined
def _note(reader, at, world, dart):
    """Note the percept of a robot that arrives by the dart ``dart``, for the second play.

    The percept has three bytes, which begin at byte ``at`` of the reader's percepts.  Memory is
    written four bytes at a time; the fourth byte has no meaning, and the next percept overwrites
    it.  If there is no room for the percept, the log is counted in ``reader.strange``, as a log for
    the Python judge.
    """
    if at + 4 > LOG_BYTES:
        reader.strange += 1
    else:
        percept = world.degree[dart] | world.marks[dart] << 8 | (world.bearing[dart] + 1) << 16
        put_entry(reader.percepts + at, 0, percept)


@inlined
def _find_map(reader, at, published):
    """Whether the logs hold a map from index ``at`` on; if so, write the map to ``published``."""
    darts = byte_of(reader.logs, at) if at + 2 <= reader.size else 0
    if darts < 1 or darts > codes.MOST_DARTS or at + 2 + 2 * darts > reader.size:
        return False
    published.darts, published.here = darts, byte_of(reader.logs, at + 1)
    published.sigma, published.alpha = address_of(reader.sigma), address_of(reader.alpha)
    first = reader.logs + at + 2
    for d in range(darts):
        put_entry(published.sigma, d, byte_of(first, d))
        put_entry(published.alpha, d, byte_of(first, darts + d))
    return True
