"""Batches of runs played by a shared library, in worlds or against records; for players alone.

A run leaves a log (:mod:`allworlds.log`), which is judged elsewhere.  The twin is
:mod:`allworlds.explorers.shared_library.native`.
"""

from __future__ import annotations

import mmap
from collections.abc import MutableSequence, Sequence
from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple

from numba import int32, types
from numpy import array, asarray, frombuffer, int32 as c_int, int64, uint8
from numpy.random import default_rng

from allworlds import log as codes
from allworlds.engines.kernel import capabilities as names
from allworlds.engines.kernel.compiling import RECORD, callback, entry, inlined, inner
from allworlds.engines.kernel.instructions import (
    LANES,
    address_of,
    ask,
    byte_of,
    call,
    entry_of,
    narrow,
    put_word,
)
from allworlds.engines.kernel.records import (
    ASKED,
    DEGREE,
    FIRST,
    HEAD,
    NONE,
    PARTNER,
    RUN_BUDGET,
    RUN_MOTIONS,
    RUN_TOLD,
    WIDE,
    Stretch,
    new,
)
from allworlds.explorers import NativeExplorer, threads_left, threads_now

# The addresses of an explorer, in their order.  There are two rooms for sigma and alpha, which take
# turns: who reads what has just been written, in other portions, waits for it to get to memory.
START, STEP, ANSWER_OF, CHOOSE, STATE, SENSED, ACTED, HERE, PICK, CONTEXT, SIGMA, ALPHA = range(12)

LONGEST_ENTRY = 4 + 2 * codes.MOST_DARTS + LANES
"""The largest number of bytes that are written in one step."""

span = inlined(codes.span)


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


class LibraryPlayer:
    """A library that plays batches which compiled code has laid out.

    Args:
        explorer: loaded here.
        beat: the number of the run, and the explorer's turns in it.
    """

    def __init__(self, explorer: NativeExplorer, beat: MutableSequence[int]) -> None:
        functions = [*explorer.library.addresses().values(), explorer.state()]
        self._memory = explorer.handed()  # it is the explorer's for good
        self._handed, self._asked = _handed(functions, self._memory, beat)
        self._memories: dict[int, Stretch] = {}
        self._threads = threads_now()

    def play(self, batch: dict[str, Any]) -> bytes | None:
        """The lengths of the logs, and the logs; None if they do not fit, or threads are left."""
        edges, runs, again = batch["edges"], batch["runs"], batch["again"]
        if edges not in self._memories:
            self._memories[edges] = Stretch(mmap.mmap(-1, Stretch.size(edges)), edges)
        memory = self._memories[edges]
        memory.heads[:runs] = frombuffer(batch["heads"], c_int).reshape(runs, HEAD)
        if again:
            sensed = frombuffer(batch["percepts"], uint8)
            memory.percepts[: len(sensed)] = sensed
            memory.starts[:runs] = frombuffer(batch["starts"], c_int)[:runs]
        else:
            memory.worlds[:runs] = frombuffer(batch["worlds"], uint8).reshape(runs, -1)
        self._asked.policy = names.POLICIES[batch["policy"]]
        order = default_rng(batch["seed"]).permutation(runs)
        size = int(play(self._handed, self._asked, memory.shared, order, again))
        left = threads_left(self._threads)
        self._threads += left
        if size < 0 or left:
            return None
        return _in_order(memory.begins[:runs].tolist(), size, memory.logs)


def _in_order(begins: list[int], size: int, logs: Any) -> bytes:
    """The lengths of logs that were written in another order, and the logs in theirs."""
    behind = dict(pairwise(sorted([*begins, size])))
    parts = [logs[begin : behind[begin]].tobytes() for begin in begins]
    return b"".join([*(len(part).to_bytes(4, "little") for part in parts), *parts])


def _handed(functions: Sequence[int], memory: Sequence[Any], beat: Any) -> tuple[Handed, Any]:
    """An explorer for compiled code, and the record that answers its choices.

    Args:
        functions: the addresses of start, step, answer, choose (0: none), and of its state.
        memory: percept, action, here, and twice sigma and alpha.
        beat: the number of the current run, and the explorer's turns in it.
    """
    asked = new(ASKED)
    parts = [frombuffer(part, c_int) for part in memory]
    percept, action, here, *rooms = parts
    asked.room = len(rooms[0])
    exchanged, lists = ([part.ctypes.data for part in some] for some in (parts[:3], rooms))
    choices = pick_address(), asarray(asked).ctypes.data
    addresses = array([*functions, *exchanged, *choices, *lists], int64)
    return Handed(addresses, percept, action, here, frombuffer(beat, int64)), asked


def load_player() -> None:
    """Load or compile the code by which a library plays."""
    memory = [bytearray(4 * length) for length in (3, 2, 1, 1, 1, 1, 1)]
    handed, asked = _handed([0] * 5, memory, bytearray(16))
    no_runs = Stretch(mmap.mmap(-1, Stretch.size(1)), 1).shared
    play(handed, asked, no_runs, array([], int64), again=False)


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
        sensed = address_of(shared.worlds) + run * shared.worlds.shape[1] + DEGREE
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
            if cost == head[RUN_BUDGET]:
                logs[at] = codes.OVER_BUDGET
                break
            degree, motion = byte_of(sensed, place), int64(action[1])
            if motion < 0 or motion >= degree:
                motion %= degree
            logs[at] = motion
            at += 1
            if not again:
                place = _arrival(sensed, place, motion, degree)
            elif cost < head[RUN_MOTIONS]:
                place += 3
            else:
                # The first play ended here.
                logs[at] = codes.BEYOND
                break
            _sense(sensed + place, handed.percept)
            cost += 1
        elif kind == names.CHECKPOINT and shown <= head[RUN_BUDGET]:
            shown += 1
            at, due = _publish(handed, asked, logs, at, codes.SHOWN, due)
            if due[0] < 0:
                break
        else:
            at, due = _end(handed, asked, logs, at, due)
            break
        action[0] = action[1] = 0
        call(explorer[STEP], (explorer[STATE], explorer[SENSED], explorer[ACTED]))
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
    leaving = place + WIDE * motion
    if leaving >= WIDE * (byte_of(sensed, place + FIRST - DEGREE) + degree):
        leaving -= WIDE * degree
    return WIDE * byte_of(sensed, leaving + PARTNER - DEGREE)


@inlined
def _begin(explorer, action, asked, head):
    """Let the explorer take the first step of an episode."""
    asked.wrong = 0
    if explorer[CHOOSE]:
        call(explorer[CHOOSE], (explorer[STATE], explorer[PICK], explorer[CONTEXT]))
    action[0] = action[1] = 0
    told = int32(head[RUN_TOLD])
    call(explorer[START], (explorer[STATE], explorer[SENSED], told, explorer[ACTED]))


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
        # The Python judge knows what a quotient is worth.
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

    If the map does not fit, BEYOND is written, and no map is due.
    """
    explorer, here, room = handed.addresses, handed.here, 1 - due[1]
    here[0] = NONE
    darts = int64(
        ask(
            explorer[ANSWER_OF],
            (
                explorer[STATE],
                int32(asked.room),
                explorer[SIGMA + 2 * room],
                explorer[ALPHA + 2 * room],
                explorer[HERE],
            ),
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
    """Write the pending map's darts; mark the log BEYOND if one of them is no byte."""
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
