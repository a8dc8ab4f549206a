"""Native explorers in compiled code: laid out, played in worlds, and played against records.

The runs are laid out first, so that the player needs no enumeration, and can take the runs in
any order.  A run leaves a log (:mod:`allworlds.engines.kernel.logs`), which is judged elsewhere.

The twins are :mod:`allworlds.judging` and :mod:`allworlds.explorers.shared_library.native`.
"""

from __future__ import annotations

from numba import int32
from numpy import int64

from allworlds.engines.kernel.calls import (
    address_of,
    ask_answer,
    call_choose,
    call_start,
    call_step,
    call_with,
    narrow,
)
from allworlds.engines.kernel.compiling import entry, inlined, inner
from allworlds.engines.kernel.gluing import advance
from allworlds.engines.kernel.known_runs import (
    RecordedRuns,
    WorldRuns,
    degree_of,
    enter,
    go,
    sense,
)
from allworlds.engines.kernel.log_codes import (
    ANSWERED,
    ILLEGAL,
    MOST_PUBLISHED,
    OVER_BUDGET,
    SHOWN,
    SHOWN_TOO_OFTEN,
    STRANGE,
)
from allworlds.engines.kernel.logs import LONGEST_ENTRY, span
from allworlds.engines.kernel.names import AMBIGUOUS, ANSWER_READY, CHECKPOINT, LANES, MOVE
from allworlds.engines.kernel.records import NONE
from allworlds.engines.kernel.stretch import (
    BEARING,
    DEGREE,
    FIRST,
    MARKS,
    MOST_PLACES,
    PARTNER,
    RUN_BUDGET,
    RUN_NUMBER,
    RUN_TOLD,
    WIDE,
)
from allworlds.engines.kernel.worlds import settle

# The addresses of an explorer, in their order.  There are two rooms for sigma and alpha, which take
# turns: who reads what has just been written, in other portions, waits for it to get to memory.
START, STEP, ANSWER_OF, CHOOSE, STATE, SENSED, ACTED, HERE, PICK, ASKED, SIGMA, ALPHA = range(12)


@entry
def lay_out(job, prefix, viable, budgets, heads, worlds):
    """Lay out runs up to ``job.until``, or till there is no more room; return their number.

    The first four are as for :func:`allworlds.engines.kernel.runs.examine`; ``job.number`` becomes
    the number of the next run, and ``job.until`` 0 behind the last.  ``heads`` and ``worlds`` are
    written, a row for each run.
    """
    g, world, placed = job.gluing, job.world, 0
    while job.number < job.until and placed <= len(heads) - 2 * MOST_PLACES:
        if not advance(g, prefix, viable):
            job.until = 0
            break
        settle(world, g)
        call_with(job.lighthouse, world)
        if world.place == NONE:
            job.number += 1
        while world.place != NONE:
            head, row = heads[placed], worlds[placed]
            head[RUN_BUDGET], head[RUN_TOLD] = budgets[world.vertices], world.told
            head[RUN_NUMBER] = job.number
            for dart in range(world.darts):
                at = WIDE * dart
                row[at + FIRST], row[at + PARTNER] = world.first[dart], world.alpha[dart]
                row[at + DEGREE], row[at + MARKS] = world.degree[dart], world.marks[dart]
                row[at + BEARING] = world.bearing[dart] + 1
            placed += 1
            job.number += 1
            call_with(job.lighthouse, world)
    return placed


@entry
def shuffle(order, seed):
    """Bring the entries into an order that the seed determines.

    Source: Fisher and Yates; Marsaglia, Xorshift RNGs (2003), with the shifts 13, 7, 17.
    """
    state = seed | 1
    for i in range(len(order) - 1, 0, -1):
        state ^= state << 13
        state ^= state >> 7 & (1 << 57) - 1
        state ^= state << 17
        other = (state >> 32 & (1 << 32) - 1) * (i + 1) >> 32
        order[i], order[other] = order[other], order[i]


@entry
def play_worlds(
    explorer, percept, action, here, room, asked, heads, worlds, order, logs, begins, beat
):
    """Play runs in worlds; return the number of bytes of the logs, -1 if there is no room.

    ``explorer`` holds addresses; the exchanged values (``percept`` to ``here``, and sigma and
    alpha of ``room`` darts) stand in memory of their own; ``asked`` answers choices.  ``heads`` and
    ``worlds`` have been laid out; the runs are played in the given ``order``.  ``logs`` are
    written, and in ``begins`` where that of each run begins.  ``beat`` tells the number of the
    current run, and the explorer's turns in it.
    """
    handed = (percept, action, here, room)
    return _play(explorer, handed, asked, heads, WorldRuns(worlds), order, logs, begins, beat)


@entry
def play_records(
    explorer,
    percept,
    action,
    here,
    room,
    asked,
    heads,
    percepts,
    starts,
    order,
    logs,
    begins,
    beat,
):
    """Play runs against the percepts of the first play, without a world.

    ``percepts`` are three bytes each, and ``starts`` says where those of a run begin.
    """
    handed = (percept, action, here, room)
    known = RecordedRuns(percepts, starts)
    return _play(explorer, handed, asked, heads, known, order, logs, begins, beat)


@inlined
def _play(explorer, handed, asked, heads, known, order, logs, begins, beat):
    """Play all runs, by the data that are known of them."""
    at, due = int64(0), NOTHING_DUE
    for run in order:
        begins[run] = at
        at, due = _episode(explorer, handed, asked, heads[run], known, run, logs, at, due, beat)
        if at < 0:
            return -1
    beat[1] = 0
    _write(explorer, logs, due)
    return at


@inlined
def _episode(explorer, handed, asked, head, known, run, logs, at, due, beat):
    """Play an episode; return where its log ends, -1 if there is no room, and what is due."""
    percept, action, _, _ = handed
    cost, shown, turn = 0, 0, 1
    place = enter(known, run)
    sense(known, run, place, percept)
    _begin(explorer, action, asked, head, beat)
    while True:
        turn += 1
        beat[1] = turn
        if at + LONGEST_ENTRY > len(logs):
            return int64(-1), due
        kind = action[0]
        if asked.wrong:
            logs[at] = STRANGE
            break
        if kind == MOVE:
            if cost == head[RUN_BUDGET]:
                logs[at] = OVER_BUDGET
                break
            degree, motion = int64(degree_of(known, run, place)), int64(action[1])
            if motion < 0 or motion >= degree:
                motion %= degree
            logs[at] = motion
            at += 1
            place = go(known, head, run, place, motion, cost)
            if place == NONE:
                logs[at] = STRANGE
                break
            sense(known, run, place, percept)
            cost += 1
        elif kind == CHECKPOINT and shown <= head[RUN_BUDGET]:
            shown += 1
            at, due = _publish(explorer, handed, logs, at, SHOWN, due)
            if due[0] < 0:
                break
        else:
            at, due = _end(explorer, handed, kind, logs, at, due)
            break
        action[0] = action[1] = 0
        call_step(explorer[STEP], explorer[STATE], explorer[SENSED], explorer[ACTED])
    return at + 1, due


@inlined
def _begin(explorer, action, asked, head, beat):
    """Let the explorer take the first step of an episode."""
    beat[0], beat[1] = head[RUN_NUMBER], 1
    asked.wrong = 0
    if explorer[CHOOSE]:
        call_choose(explorer[CHOOSE], explorer[STATE], explorer[PICK], explorer[ASKED])
    action[0] = action[1] = 0
    call_start(
        explorer[START], explorer[STATE], explorer[SENSED], int32(head[RUN_TOLD]), explorer[ACTED]
    )


@inlined
def _end(explorer, handed, kind, logs, at, due):
    """Write the end of the log, with an answer or without; return its place, and what is due."""
    if kind == ANSWER_READY:
        at, due = _publish(explorer, handed, logs, at, ANSWERED, due)
        if due[0] >= 0:
            at -= 1
    elif kind == CHECKPOINT:
        logs[at] = SHOWN_TOO_OFTEN
    elif kind == AMBIGUOUS:
        # The other engine knows what a quotient is worth.
        logs[at] = STRANGE
    else:
        logs[at] = ILLEGAL
    return at, due


# What has been published, and is to be written into the log when the next thing is: where, from
# which room, and how many darts.
NOTHING_DUE = (int64(-1), int64(0), int64(0))


@inlined
def _publish(explorer, handed, logs, at, what, due):
    """Write a published map; return the place behind it, and the address of the map that is due.

    If the map does not fit, STRANGE is written, and no map is due.
    """
    _, _, here, capacity = handed
    room = 1 - due[1]
    here[0] = NONE
    darts = int64(
        ask_answer(
            explorer[ANSWER_OF],
            explorer[STATE],
            int32(capacity),
            explorer[SIGMA + 2 * room],
            explorer[ALPHA + 2 * room],
            explorer[HERE],
        )
    )
    _write(explorer, logs, due)
    if darts < 1 or darts > MOST_PUBLISHED or here[0] < 0 or here[0] > 255:
        logs[at] = STRANGE
        return at, NOTHING_DUE
    logs[at], logs[at + 1], logs[at + 2] = what, darts, here[0]
    return at + 3 + span(darts), (at, room, darts)


@inner
def _write(explorer, logs, due):
    """Write the pending map's darts; mark the log STRANGE if one of them is no byte."""
    at, room, darts = due
    if at < 0:
        return
    odd, sigma = int64(0), address_of(logs) + at + 3
    # What is written too much of sigma is written over.
    for dart in range(0, darts, LANES):
        odd |= narrow(sigma + dart, explorer[SIGMA + 2 * room] + 4 * dart, darts - dart)
    for dart in range(0, darts, LANES):
        odd |= narrow(sigma + darts + dart, explorer[ALPHA + 2 * room] + 4 * dart, darts - dart)
    if odd:
        logs[at] = STRANGE
