"""The log of a run in bytes: each motion, what has been published, and how it ended.

Who plays writes it (:mod:`allworlds.kernel.native`); here it is read again, as an explorer that
does what the log says, and notes what it senses for the second play.
"""

from __future__ import annotations

from numpy import int64

from allworlds.kernel.calls import (
    LANES,
    address_of,
    byte_of,
    entry_of,
    put_byte,
    put_entry,
    widen,
    word_of,
)
from allworlds.kernel.compiling import entry, inlined, inner
from allworlds.kernel.names import ANSWER_READY, CHECKPOINT, MOVE

# Motions below the first of these, and then how it goes on.
LARGEST_MOTION = 199
SHOWN, ANSWERED, OVER_BUDGET, SHOWN_TOO_OFTEN, ILLEGAL, STRANGE = range(200, 206)

MOST_PUBLISHED = 64
"""So many darts, more than a world has, can be read again; more are left to the general engine."""

LONGEST_ENTRY = 4 + 2 * MOST_PUBLISHED + LANES
"""The largest number of bytes that are written in one step."""

SLACK = LANES
"""So many bytes behind a log may be read; they mean nothing."""


@inlined
def begin_reading(reader):
    """The next log, from its beginning."""
    reader.at = entry_of(reader.begins, reader.run)
    if reader.at < 0:
        reader.at = reader.size
    put_entry(reader.starts, reader.run, reader.noted)
    reader.run += 1
    _note(reader)
    _read(reader)


@inlined
def go_on_reading(reader):
    """What the log says next."""
    if reader.moved:
        _note(reader)
    _read(reader)


@inlined
def show(reader, answer):
    """What it says that was published."""
    answer.sigma, answer.alpha = address_of(reader.sigma), address_of(reader.alpha)
    answer.darts, answer.here = reader.darts, reader.here


@inner
def _note(reader):
    """A percept, for the second play."""
    at, percept = reader.noted, reader.percept
    if at + 3 > reader.room:
        reader.strange += 1
        return
    put_byte(reader.percepts, at, int64(percept.degree))
    put_byte(reader.percepts, at + 1, int64(percept.marks))
    put_byte(reader.percepts, at + 2, int64(percept.bearing + 1))
    reader.noted = at + 3


@inner
def _read(reader):
    """The next entry of the log; one that is none ends the run, and is counted."""
    action = reader.action
    reader.moved = 0
    code = STRANGE
    if reader.at < reader.size:
        code = byte_of(reader.logs, reader.at)
    reader.at += 1
    if code <= LARGEST_MOTION:
        action.kind, action.motion = MOVE, code
        reader.moved = 1
        return
    if code == SHOWN or code == ANSWERED:
        if _read_map(reader):
            action.kind = CHECKPOINT if code == SHOWN else ANSWER_READY
        else:
            action.kind = 0
            reader.strange += 1
    put_entry(reader.ends, reader.run - 1, reader.at)
    if code == OVER_BUDGET:
        # What would be one motion more than is legal; if it is legal, the log ends behind it.
        action.kind, action.motion = MOVE, 0
        reader.at = reader.size
    elif code == SHOWN_TOO_OFTEN:
        action.kind = CHECKPOINT
        reader.darts = 0
        reader.at = reader.size
    elif code >= ILLEGAL:
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
    source, sigma, alpha = reader.logs + at, address_of(reader.sigma), address_of(reader.alpha)
    for dart in range(0, darts, LANES):
        widen(sigma + 4 * dart, source + dart)
        widen(alpha + 4 * dart, source + darts + dart)
    reader.darts, reader.here = darts, here
    reader.at = at + 2 * darts
    return True


@entry
def differing(first, begins, ends, second, again, runs, different):
    """How many of the runs have second logs that are not as the first; noted in ``different``.

    What is published on the way is judged once, and need not be the same again.

    ``first`` and ``second`` are the bytes of the logs, and ``begins`` and ``again`` say where that
    of each run begins; ``ends`` where the first ends.  A log tells where it ends, so that one which
    is longer differs in what the other one has.
    """
    found = 0
    one, other = address_of(first), address_of(second)
    for run in range(runs):
        a, b = int64(begins[run]), int64(again[run])
        length, room = int64(ends[run]) - a, len(second) - b
        inside = a >= 0 and b >= 0 and a + length <= len(first)
        same = length > 0 and inside and length <= room and _same(one + a, other + b, length)
        if not (same or (inside and _mean_the_same(one + a, length, other + b, room))):
            different[found] = run
            found += 1
    return found


@inner
def _mean_the_same(one, length, other, room):
    """Whether the logs have the same motions and end in the same way, whatever they show."""
    a, b = _behind_the_shown(one, 0, length), _behind_the_shown(other, 0, room)
    while a < length and b < room:
        code = byte_of(one, a)
        if code != byte_of(other, b):
            return False
        if code > LARGEST_MOTION:
            rest = length - a
            return rest <= room - b and _same(one + a, other + b, rest)
        a, b = _behind_the_shown(one, a + 1, length), _behind_the_shown(other, b + 1, room)
    return False


@inlined
def _behind_the_shown(log, at, end):
    """Where the log goes on behind what has been published there."""
    while at + 1 < end and byte_of(log, at) == SHOWN:
        at += 3 + 2 * byte_of(log, at + 1)
    return at


@inlined
def _same(one, other, length):
    """Whether so many bytes are the same."""
    differ, at = int64(0), 0
    while at + 8 <= length:
        differ |= word_of(one, at) ^ word_of(other, at)
        at += 8
    while at < length:
        differ |= byte_of(one, at) ^ byte_of(other, at)
        at += 1
    return differ == 0
