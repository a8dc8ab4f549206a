"""Native explorers in compiled code: played in worlds, played against records, and read again.

What is played is laid out first, so that who plays needs no enumeration, and can take the runs in
any order.  A run leaves a log of bytes: each motion, what it has published, and how it ended.  The
log is judged elsewhere: a reader, itself an explorer, does what the log says in the true world, and
notes what is sensed there for the second play.

The twins are :mod:`allworlds.episode` and :mod:`allworlds.libraries.explorer`.
"""

from __future__ import annotations

from functools import cache

from numba import int32, types
from numpy import int64

from allworlds.kernel.calls import (
    address_of,
    ask_answer,
    byte_of,
    call_choose,
    call_start,
    call_step,
    call_with,
    entry_of,
    put_byte,
    put_entry,
)
from allworlds.kernel.compiling import RECORD, callback, entry, inlined, inner
from allworlds.kernel.gluing import advance
from allworlds.kernel.names import ANSWER_READY, CHECKPOINT, LIFO, MOVE, NEAREST
from allworlds.kernel.records import ACTION, ANSWER, NONE, PERCEPT, POLICY, READER
from allworlds.kernel.worlds import settle

# A log: motions below the first of these, and then how it goes on.
LARGEST_MOTION = 199
SHOWN, ANSWERED, OVER_BUDGET, SHOWN_TOO_OFTEN, ILLEGAL, STRANGE = range(200, 206)

MOST_PUBLISHED = 64
"""So many darts, more than a world has, can be read again; more are left to the general engine."""

LONGEST_ENTRY = 4 + 2 * MOST_PUBLISHED
"""The largest number of bytes that one step adds to a log."""

MOST_PLACES = 64
"""More places than a lighthouse has in one map."""

# The columns of what is said of a run besides: its budget, what is told, its number in its unit,
# and against records how many motions were made.
RUN_BUDGET, RUN_TOLD, RUN_NUMBER, RUN_MOTIONS = range(4)
HEAD = 4

# The columns of a laid-out world, for each dart: the first dart of its vertex, its partner, and
# what is sensed on arriving by it.
FIRST, PARTNER, DEGREE, MARKS, BEARING = range(5)
WIDE = 5

# The addresses of an explorer, in their order.
START, STEP, ANSWER_OF, CHOOSE, STATE, SENSED, ACTED, SIGMA, ALPHA, HERE, PICK, ASKED = range(12)
ADDRESSES = 12


@entry
def lay_out(job, prefix, viable, budgets, heads, worlds):
    """How many runs have been laid out, up to ``job.until``, or till there is no more room.

    The first four are as for :func:`allworlds.kernel.runs.examine`; ``job.number`` becomes the
    number of the next run, and ``job.until`` 0 behind the last.  ``heads`` and ``worlds`` are
    written, a row for each run.
    """
    g, world, lit = job.gluing, job.world, 0
    while job.number < job.until and lit <= len(heads) - 2 * MOST_PLACES:
        if not advance(g, prefix, viable):
            job.until = 0
            break
        settle(world, g)
        call_with(job.lighthouse, world)
        if world.place == NONE:
            job.number += 1
        while world.place != NONE:
            head, row = heads[lit], worlds[lit]
            head[RUN_BUDGET], head[RUN_TOLD] = budgets[world.vertices], world.told
            head[RUN_NUMBER] = job.number
            for dart in range(world.darts):
                at = WIDE * dart
                row[at + FIRST], row[at + PARTNER] = world.first[dart], world.alpha[dart]
                row[at + DEGREE], row[at + MARKS] = world.degree[dart], world.marks[dart]
                row[at + BEARING] = world.bearing[dart] + 1
            lit += 1
            job.number += 1
            call_with(job.lighthouse, world)
    return lit


@entry
def play_worlds(
    explorer, percept, action, here, sigma, alpha, asked, heads, worlds, order, logs, begins, beat
):
    """The number of bytes of the logs; -1 if there is no room for them.

    ``explorer`` holds addresses; what is handed to and fro (``percept`` to ``alpha``) stands in
    memory of its own; ``asked`` answers choices.  ``heads`` and ``worlds`` have been laid out; the
    runs are played in the given ``order``.  ``logs`` are written, and in ``begins`` where that of
    each run begins.  ``beat`` tells the number of the current run, and the explorer's turns in it.
    """
    at = int64(0)
    for run in order:
        head, world = heads[run], worlds[run]
        begins[run] = at
        dart = int64(0)
        cost, shown, turn = 0, 0, 1
        _sense(percept, world, dart)
        _begin(explorer, action, asked, head, beat)
        while True:
            turn += 1
            beat[1] = turn
            if at + LONGEST_ENTRY > len(logs):
                return -1
            kind = action[0]
            if asked.wrong:
                logs[at] = STRANGE
                break
            if kind == MOVE:
                if cost == head[RUN_BUDGET]:
                    logs[at] = OVER_BUDGET
                    break
                degree = int64(world[WIDE * dart + DEGREE])
                motion = int64(action[1])
                if motion < 0 or motion >= degree:
                    motion %= degree
                spot = dart + motion
                if spot >= int64(world[WIDE * dart + FIRST]) + degree:
                    spot -= degree
                dart = int64(world[WIDE * spot + PARTNER])
                _sense(percept, world, dart)
                logs[at] = motion
                at += 1
                cost += 1
            elif kind == CHECKPOINT and shown <= head[RUN_BUDGET]:
                shown += 1
                at = _publish(explorer, here, sigma, alpha, logs, at, SHOWN)
                if logs[at] == STRANGE:
                    break
            else:
                at = _end(explorer, kind, here, sigma, alpha, logs, at)
                break
            action[0] = action[1] = 0
            call_step(explorer[STEP], explorer[STATE], explorer[SENSED], explorer[ACTED])
        at += 1
    beat[1] = 0
    return at


@entry
def play_records(
    explorer,
    percept,
    action,
    here,
    sigma,
    alpha,
    asked,
    heads,
    percepts,
    starts,
    order,
    logs,
    begins,
    beat,
):
    """The same against what was sensed in the first play, without a world.

    ``percepts`` are three bytes each, and ``starts`` says where those of a run begin.
    """
    at = 0
    for run in order:
        head, sensed = heads[run], int64(starts[run])
        begins[run] = at
        cost, shown, turn = 0, 0, 1
        _hear(percept, percepts, sensed)
        _begin(explorer, action, asked, head, beat)
        while True:
            turn += 1
            beat[1] = turn
            if at + LONGEST_ENTRY > len(logs):
                return -1
            kind = action[0]
            if asked.wrong:
                logs[at] = STRANGE
                break
            if kind == MOVE:
                if cost == head[RUN_BUDGET]:
                    logs[at] = OVER_BUDGET
                    break
                degree = int64(percepts[sensed])
                motion = int64(action[1])
                if motion < 0 or motion >= degree:
                    motion %= degree
                logs[at] = motion
                if cost == head[RUN_MOTIONS]:
                    # Here the first play had ended: this one is another.
                    at += 1
                    logs[at] = STRANGE
                    break
                sensed += 3
                _hear(percept, percepts, sensed)
                at += 1
                cost += 1
            elif kind == CHECKPOINT and shown <= head[RUN_BUDGET]:
                shown += 1
                at = _publish(explorer, here, sigma, alpha, logs, at, SHOWN)
                if logs[at] == STRANGE:
                    break
            else:
                at = _end(explorer, kind, here, sigma, alpha, logs, at)
                break
            action[0] = action[1] = 0
            call_step(explorer[STEP], explorer[STATE], explorer[SENSED], explorer[ACTED])
        at += 1
    beat[1] = 0
    return at


@inlined
def _sense(percept, world, dart):
    """What is sensed on arriving by the dart."""
    at = WIDE * dart
    percept[0], percept[1] = world[at + DEGREE], world[at + MARKS]
    percept[2] = int32(world[at + BEARING]) - 1


@inlined
def _hear(percept, percepts, at):
    """What was sensed."""
    percept[0], percept[1] = percepts[at], percepts[at + 1]
    percept[2] = int32(percepts[at + 2]) - 1


@inner
def _begin(explorer, action, asked, head, beat):
    """The first step of an episode."""
    beat[0], beat[1] = head[RUN_NUMBER], 1
    asked.wrong = 0
    if explorer[CHOOSE]:
        call_choose(explorer[CHOOSE], explorer[STATE], explorer[PICK], explorer[ASKED])
    action[0] = action[1] = 0
    call_start(
        explorer[START], explorer[STATE], explorer[SENSED], int32(head[RUN_TOLD]), explorer[ACTED]
    )


@inner
def _end(explorer, kind, here, sigma, alpha, logs, at):
    """Where the log ends: with an answer, or what is none."""
    if kind == ANSWER_READY:
        at = _publish(explorer, here, sigma, alpha, logs, at, ANSWERED)
        if logs[at] != STRANGE:
            at -= 1
    elif kind == CHECKPOINT:
        logs[at] = SHOWN_TOO_OFTEN
    else:
        logs[at] = ILLEGAL
    return at


@inner
def _publish(explorer, here, sigma, alpha, logs, at, what):
    """Where the log goes on behind what was published; STRANGE stands there if that is no use."""
    here[0] = NONE
    darts = ask_answer(
        explorer[ANSWER_OF],
        explorer[STATE],
        int32(len(sigma)),
        explorer[SIGMA],
        explorer[ALPHA],
        explorer[HERE],
    )
    if darts < 1 or darts > MOST_PUBLISHED or here[0] < 0 or here[0] > 255:
        logs[at] = STRANGE
        return at
    logs[at], logs[at + 1], logs[at + 2] = what, darts, here[0]
    odd = 0
    for dart in range(darts):
        logs[at + 3 + dart], logs[at + 3 + darts + dart] = sigma[dart], alpha[dart]
        odd |= sigma[dart] | alpha[dart]
    if odd < 0 or odd > 255:
        logs[at] = STRANGE
        return at
    at += 3 + 2 * darts
    logs[at] = 0
    return at


def pick(asked, of, options, cost):  # pragma: no cover  # compiled
    """``allworlds_pick``, as the policies answer."""
    if options < 1 or of < 0 or of > 3:
        asked.wrong = 1
        return int32(0)
    if of != 0:
        return int32(0)
    if asked.policy == LIFO:
        return int32(options - 1)
    taken = 0
    if asked.policy == NEAREST and cost:
        for i in range(1, options):
            if entry_of(cost, i) < entry_of(cost, taken):
                taken = i
    return int32(taken)


@cache
def pick_address() -> int:
    """Where the policies are."""
    return callback(pick, types.int32(RECORD(POLICY), types.int32, types.int32, types.int64))


# ---------------------------------------------------------------- reading a log again


def begin_reading(reader, percept, _told, action):  # pragma: no cover  # compiled
    """The next log, from its beginning."""
    reader.at = entry_of(reader.begins, reader.run)
    if reader.at < 0:
        reader.at = reader.size
    put_entry(reader.ends, reader.run, reader.noted)
    reader.run += 1
    _note(reader, percept)
    _read(reader, action)


def go_on_reading(reader, percept, action):  # pragma: no cover  # compiled
    """What the log says next."""
    if reader.moved:
        _note(reader, percept)
    _read(reader, action)


def published(reader, answer):  # pragma: no cover  # compiled
    """What it says that was published."""
    answer.sigma, answer.alpha = address_of(reader.sigma), address_of(reader.alpha)
    answer.darts, answer.here = reader.darts, reader.here


@inner
def _note(reader, percept):
    """A percept, for the second play."""
    at = reader.noted
    if at + 3 > reader.room:
        reader.strange += 1
        return
    put_byte(reader.percepts, at, int64(percept.degree))
    put_byte(reader.percepts, at + 1, int64(percept.marks))
    put_byte(reader.percepts, at + 2, int64(percept.bearing + 1))
    reader.noted = at + 3


@inner
def _read(reader, action):
    """The next entry of the log; one that is none ends the run, and is counted."""
    reader.moved = 0
    code = STRANGE
    if reader.at < reader.size:
        code = byte_of(reader.logs, reader.at)
    reader.at += 1
    if code <= LARGEST_MOTION:
        action.kind, action.motion = MOVE, code
        reader.moved = 1
    elif code == OVER_BUDGET:
        # What would be one motion more than is legal; if it is legal, the log ends behind it.
        action.kind, action.motion = MOVE, 0
        reader.at = reader.size
    elif code == SHOWN_TOO_OFTEN:
        action.kind = CHECKPOINT
        reader.darts = 0
        reader.at = reader.size
    elif (code == SHOWN or code == ANSWERED) and _read_map(reader):
        action.kind = CHECKPOINT if code == SHOWN else ANSWER_READY
    else:
        action.kind = 0
        if code != ILLEGAL:
            reader.strange += 1


@inner
def _read_map(reader):
    """Whether there is a published map in the log; it comes to stand in the reader."""
    if reader.at + 2 > reader.size:
        return False
    darts, here = byte_of(reader.logs, reader.at), byte_of(reader.logs, reader.at + 1)
    at = reader.at + 2
    if darts < 1 or darts > MOST_PUBLISHED or at + 2 * darts > reader.size:
        return False
    for dart in range(darts):
        reader.sigma[dart] = byte_of(reader.logs, at + dart)
        reader.alpha[dart] = byte_of(reader.logs, at + darts + dart)
    reader.darts, reader.here = darts, here
    reader.at = at + 2 * darts
    return True


@cache
def reader_addresses() -> tuple[int, int, int]:
    """Where the reader is: start, step, answer."""
    reader, percept, action = RECORD(READER), RECORD(PERCEPT), RECORD(ACTION)
    return (
        callback(begin_reading, types.void(reader, percept, types.int32, action)),
        callback(go_on_reading, types.void(reader, percept, action)),
        callback(published, types.void(reader, RECORD(ANSWER))),
    )


@entry
def differing(first, begins, second, again, runs, different):
    """How many of the runs have logs that differ; which is noted in ``different``.

    ``first`` and ``second`` are the bytes of the logs, and ``begins`` and ``again`` say where that
    of each run begins.
    """
    found = 0
    for run in range(runs):
        if not _same(first, int64(begins[run]), second, int64(again[run])):
            different[found] = run
            found += 1
    return found


@inner
def _same(first, a, second, b):
    """Whether two logs say the same."""
    while True:
        if a < 0 or b < 0 or a >= len(first) or b >= len(second) or first[a] != second[b]:
            return False
        code = first[a]
        if code == SHOWN or code == ANSWERED:
            if a + 1 >= len(first):
                return False
            length = 3 + 2 * int64(first[a + 1])
            if a + length > len(first) or b + length > len(second):
                return False
            for i in range(1, length):
                if first[a + i] != second[b + i]:
                    return False
            if code == ANSWERED:
                return True
            a += length
            b += length
        elif code <= LARGEST_MOTION:
            a += 1
            b += 1
        else:
            return True
