"""Native explorers in compiled code: laid out, played in worlds, and played against records.

The runs are laid out first, so that the player needs no enumeration, and can take the runs in
any order.  A run leaves a log (:mod:`allworlds.engines.kernel.logs`), which is judged elsewhere.

The twins are :mod:`allworlds.judging` and :mod:`allworlds.explorers.shared_library.native`.
"""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

from numba import int32, types
from numpy import int64

from allworlds import log as codes
from allworlds.engines.kernel import names, stretch
from allworlds.engines.kernel.calls import (
    address_of,
    ask_answer,
    byte_of,
    call_choose,
    call_start,
    call_step,
    call_with,
    entry_of,
    narrow,
    put_word,
)
from allworlds.engines.kernel.compiling import RECORD, callback, entry, inlined, inner
from allworlds.engines.kernel.gluing import advance
from allworlds.engines.kernel.logs import LONGEST_ENTRY, span
from allworlds.engines.kernel.records import ASKED, NONE
from allworlds.engines.kernel.worlds import settle

# The addresses of an explorer, in their order.  There are two rooms for sigma and alpha, which take
# turns: who reads what has just been written, in other portions, waits for it to get to memory.
START, STEP, ANSWER_OF, CHOOSE, STATE, SENSED, ACTED, HERE, PICK, CONTEXT, SIGMA, ALPHA = range(12)


class Handed(NamedTuple):
    """A native explorer.

    Attributes:
        addresses: its own, and those of what is handed to it.
        percept, action, here: the exchanged values, in memory of their own.
        beat: the number of the current run, and the explorer's turns in it.
    """

    addresses: Any
    percept: Any
    action: Any
    here: Any
    beat: Any


class Shared(NamedTuple):
    """The parts of a :class:`~allworlds.engines.kernel.stretch.Stretch` as arrays."""

    heads: Any
    worlds: Any
    percepts: Any
    starts: Any
    logs: Any
    begins: Any


@entry
def lay_out(job, unit, heads, worlds):
    """Lay out runs up to ``job.until``, or till there is no more room; return their number.

    The first two are as for :func:`allworlds.engines.kernel.runs.examine`; ``job.number`` becomes
    the number of the next run, and ``job.until`` 0 behind the last.  ``heads`` and ``worlds`` are
    written, a row for each run.
    """
    g, world, placed = job.gluing, job.world, 0
    while job.number < job.until and placed <= len(heads) - 2 * stretch.MOST_PLACES:
        if not advance(g, unit.prefix, unit.viable):
            job.until = 0
            break
        settle(world, g)
        call_with(job.lighthouse, world)
        if world.place == NONE:
            job.number += 1
        while world.place != NONE:
            head, row = heads[placed], worlds[placed]
            head[stretch.RUN_BUDGET] = unit.budgets[world.vertices]
            head[stretch.RUN_TOLD], head[stretch.RUN_NUMBER] = world.told, job.number
            for dart in range(world.darts):
                at = stretch.WIDE * dart
                row[at + stretch.FIRST] = world.first[dart]
                row[at + stretch.PARTNER] = world.alpha[dart]
                row[at + stretch.DEGREE] = world.degree[dart]
                row[at + stretch.MARKS] = world.marks[dart]
                row[at + stretch.BEARING] = world.bearing[dart] + 1
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
def play(handed, asked, shared, order, again):
    """Play runs; return the number of bytes of their logs, -1 if there is no room.

    Args:
        handed: the explorer.
        asked: answers its choices; a record of :data:`~allworlds.engines.kernel.records.ASKED`.
        shared: runs that have been laid out; the logs are written, and where each begins.
        order: the runs, in the order in which they are played.
        again: whether they are played without a world, against the percepts of the first play.
    """
    at, due = int64(0), NOTHING_DUE
    for run in order:
        shared.begins[run] = at
        at, due = _episode(handed, asked, shared, run, again, at, due)
        if at < 0:
            return -1
    handed.beat[1] = 0
    _write(handed.addresses, shared.logs, due)
    return at


@inlined
def _episode(handed, asked, shared, run, again, at, due):
    """Play an episode; return where its log ends, -1 if there is no room, and what is due."""
    explorer, action, head, logs = handed.addresses, handed.action, shared.heads[run], shared.logs
    cost, shown, turn = 0, 0, 1
    # Where three bytes are for each percept, and which of them is the present one.
    place, sensed = int64(0), int64(0)
    if again:
        sensed = address_of(shared.percepts) + int64(shared.starts[run])
    else:
        sensed = address_of(shared.worlds) + run * shared.worlds.shape[1] + stretch.DEGREE
    _sense(sensed + place, handed.percept)
    handed.beat[0], handed.beat[1] = run, 1
    _begin(explorer, action, asked, head)
    while True:
        turn += 1
        handed.beat[1] = turn
        if at + LONGEST_ENTRY > len(logs):
            return int64(-1), due
        kind = action[0]
        if asked.wrong:
            logs[at] = codes.BEYOND
            break
        if kind == names.MOVE:
            if cost == head[stretch.RUN_BUDGET]:
                logs[at] = codes.OVER_BUDGET
                break
            degree, motion = byte_of(sensed, place), int64(action[1])
            if motion < 0 or motion >= degree:
                motion %= degree
            logs[at] = motion
            at += 1
            if not again:
                place = _arrival(sensed, place, motion, degree)
            elif cost < head[stretch.RUN_MOTIONS]:
                place += 3
            else:
                # The first play ended here.
                logs[at] = codes.BEYOND
                break
            _sense(sensed + place, handed.percept)
            cost += 1
        elif kind == names.CHECKPOINT and shown <= head[stretch.RUN_BUDGET]:
            shown += 1
            at, due = _publish(handed, asked, logs, at, codes.SHOWN, due)
            if due[0] < 0:
                break
        else:
            at, due = _end(handed, asked, logs, at, due)
            break
        action[0] = action[1] = 0
        call_step(explorer[STEP], explorer[STATE], explorer[SENSED], explorer[ACTED])
    return at + 1, due


@inlined
def _sense(address, percept):
    """Write the percept whose three bytes are at the address."""
    # Degree and marks are stored at once: who copies both waits for nothing.
    put_word(address_of(percept), byte_of(address, 0) | byte_of(address, 1) << 32)
    percept[2] = byte_of(address, 2) - 1


@inlined
def _arrival(sensed, place, motion, degree):
    """The place of the percept behind the motion, in a laid-out world."""
    leaving = place + stretch.WIDE * motion
    if leaving >= stretch.WIDE * (byte_of(sensed, place + stretch.FIRST - stretch.DEGREE) + degree):
        leaving -= stretch.WIDE * degree
    return stretch.WIDE * byte_of(sensed, leaving + stretch.PARTNER - stretch.DEGREE)


@inlined
def _begin(explorer, action, asked, head):
    """Let the explorer take the first step of an episode."""
    asked.wrong = 0
    if explorer[CHOOSE]:
        call_choose(explorer[CHOOSE], explorer[STATE], explorer[PICK], explorer[CONTEXT])
    action[0] = action[1] = 0
    told = int32(head[stretch.RUN_TOLD])
    call_start(explorer[START], explorer[STATE], explorer[SENSED], told, explorer[ACTED])


@inlined
def _end(handed, asked, logs, at, due):
    """Write the end of the log, with an answer or without; return its place, and what is due."""
    kind = handed.action[0]
    if kind == names.ANSWER_READY:
        at, due = _publish(handed, asked, logs, at, codes.ANSWERED, due)
        if due[0] >= 0:
            at -= 1
    elif kind == names.CHECKPOINT:
        logs[at] = codes.SHOWN_TOO_OFTEN
    elif kind == names.AMBIGUOUS:
        # The other engine knows what a quotient is worth.
        logs[at] = codes.BEYOND
    else:
        logs[at] = codes.FAULT
    return at, due


# What has been published, and is to be written into the log when the next thing is: where, from
# which room, and how many darts.
NOTHING_DUE = (int64(-1), int64(0), int64(0))


@inlined
def _publish(handed, asked, logs, at, what, due):
    """Write a published map; return the place behind it, and the address of the map that is due.

    If the map does not fit, STRANGE is written, and no map is due.
    """
    explorer, here, room = handed.addresses, handed.here, 1 - due[1]
    here[0] = NONE
    darts = int64(
        ask_answer(
            explorer[ANSWER_OF],
            explorer[STATE],
            int32(asked.room),
            explorer[SIGMA + 2 * room],
            explorer[ALPHA + 2 * room],
            explorer[HERE],
        )
    )
    _write(explorer, logs, due)
    if darts < 1 or darts > codes.MOST_DARTS or here[0] < 0 or here[0] > 255:
        logs[at] = codes.BEYOND
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
    for dart in range(0, darts, names.LANES):
        odd |= narrow(sigma + dart, explorer[SIGMA + 2 * room] + 4 * dart, darts - dart)
    for dart in range(0, darts, names.LANES):
        odd |= narrow(sigma + darts + dart, explorer[ALPHA + 2 * room] + 4 * dart, darts - dart)
    if odd:
        logs[at] = codes.BEYOND


def pick(asked, of, options, cost):  # pragma: no cover  # compiled
    """Answer ``allworlds_pick`` by the policy."""
    if options < 1 or of < 0 or of > 3:
        asked.wrong = 1
        return int32(0)
    if of != 0:
        return int32(0)
    if asked.policy == names.LIFO:
        return int32(options - 1)
    taken = 0
    if asked.policy == names.NEAREST and cost:
        for i in range(1, options):
            if entry_of(cost, i) < entry_of(cost, taken):
                taken = i
    return int32(taken)


@cache
def pick_address() -> int:
    """The address of the compiled answers."""
    return callback(pick, types.int32(RECORD(ASKED), types.int32, types.int32, types.int64))
