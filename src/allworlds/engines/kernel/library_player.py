"""Batches of runs that a shared library plays; only player processes use this module.

A batch is played in its worlds, and then again by the percepts of this first play.  A run yields a
log (:mod:`allworlds.log`), which another process judges.  The memory of a batch is a
:class:`Stretch`, named ``memory`` or ``shared``: runs are read from it, and logs are written to it.
The twin, Python code with the same logs: :mod:`allworlds.explorers.shared_library`.
"""

from collections.abc import MutableSequence, Sequence
from functools import cache
from typing import Any, NamedTuple

from numba import int32, types
from numpy import array, diff, empty, frombuffer, int32 as c_int, int64, uint8
from numpy.random import default_rng

from allworlds import log as codes
from allworlds.engines.kernel import arrays as layout, capabilities as names
from allworlds.engines.kernel.arrays import LIBRARY, NONE, Stretch, new
from allworlds.engines.kernel.compiling import (
    RECORD,
    address_of,
    ask,
    byte_of,
    call,
    callback,
    entry,
    entry_of,
    inlined,
    inner,
)
from allworlds.explorers.shared_library import NativeExplorer, threads_left, threads_now

LONGEST_ENTRY = 3 + 2 * codes.MOST_DARTS
"""The largest number of bytes that one step of a run writes to the log."""


class Handed(NamedTuple):
    """An explorer in a shared library, in the form that compiled code takes.

    ``library`` is a structured array ``LIBRARY``: the addresses of the explorer's functions, and
    more.  ``percept``, ``action`` and ``here`` are the memory of the values that are exchanged with
    the explorer; ``here`` is the dart in an answer.  ``beat`` holds the number of the run and the
    number of the explorer's turn in the run.
    """

    library: Any
    percept: Any
    action: Any
    here: Any
    beat: Any


class LibraryPlayer:
    """The player of a shared library, for batches whose worlds compiled code has written to arrays.

    Args:
        explorer: the explorer, loaded in this process.
        beat: two shared numbers: the number of the run, and the number of the explorer's turn in
            the run.
    """

    def __init__(self, explorer: NativeExplorer, beat: MutableSequence[int]) -> None:
        functions = [*explorer.library.addresses(), explorer.state()]
        self._memory = explorer.handed()  # the explorer uses it until it ends
        self._handed = _handed(functions, self._memory, beat)
        self._memories: dict[int, Stretch] = {}
        self._threads = threads_now()
        self._moved = empty(layout.LOG_BYTES, uint8)

    def play(self, batch: dict[str, Any]) -> tuple[bytes, Any] | None:
        """Play a batch; return the lengths of the logs, packed as four bytes each, and the logs.

        Return None if the logs do not fit into memory, or if the library has left new threads
        running.  ``batch`` is the message that asks for the plays: its parts by their names.
        """
        edges, runs, again = batch["edges"], batch["runs"], batch["again"]
        if edges not in self._memories:
            self._memories[edges] = Stretch.of(edges)
        memory = self._memories[edges]
        memory.heads[:runs] = frombuffer(batch["heads"], c_int).reshape(runs, layout.HEAD)
        if again:
            sensed = frombuffer(batch["percepts"], uint8)
            memory.percepts[: len(sensed)] = sensed
            memory.starts[:runs] = frombuffer(batch["starts"], c_int)[:runs]
        else:
            memory.worlds[:runs] = frombuffer(batch["worlds"], uint8).reshape(runs, -1)
        self._handed.library.policy = names.POLICIES[batch["policy"]]
        order = default_rng(batch["seed"]).permutation(runs)
        size = int(play(self._handed, memory, order, again))
        left = threads_left(self._threads)
        self._threads += left
        if size < 0 or left:
            return None
        return self._in_order(order, size, memory)

    def _in_order(self, order: Any, size: int, memory: Stretch) -> tuple[bytes, Any]:
        """The lengths of the logs, packed as bytes, and the logs; both sorted by the runs' numbers.

        ``memory`` holds the logs, ``size`` bytes in all, in the order in which the runs were
        played.  ``order`` holds the numbers of the runs in this order.
        """
        begins, lengths = memory.begins[: len(order)], empty(len(order), c_int)
        lengths[order] = diff(begins[order], append=c_int(size))
        move(begins, lengths, memory.logs, self._moved)
        return lengths.tobytes(), self._moved[:size]


def _handed(functions: Sequence[int], memory: Sequence[Any], beat: Any) -> Handed:
    """An explorer in a shared library, in the form that compiled code takes.

    ``functions`` holds the addresses of the functions start, step, answer and choose, and of the
    state; the address of choose is 0 if the explorer has no such function.  ``memory`` consists of
    percept, action, here, sigma and alpha.
    """
    library = new(LIBRARY)
    percept, action, here, sigma, alpha = (frombuffer(part, c_int) for part in memory)
    library.start, library.step, library.answer, library.choose, library.state = functions
    library.percept, library.action = percept.ctypes.data, action.ctypes.data
    library.here, library.pick = here.ctypes.data, pick_address()
    library.sigma, library.alpha, library.room = sigma.ctypes.data, alpha.ctypes.data, len(sigma)
    return Handed(library, percept, action, here, frombuffer(beat, int64))


def load_player() -> None:
    """Load or compile the code that plays a shared library."""
    memory = [bytearray(4 * length) for length in (3, 2, 1, 1, 1)]
    handed = _handed([0] * 5, memory, bytearray(16))
    no_runs = Stretch.of(1)
    play(handed, no_runs, array([], int64), again=False)
    move(no_runs.begins, no_runs.begins[:0], no_runs.logs, no_runs.logs)


@entry
def move(begins, lengths, logs, moved):
    """Copy parts of ``logs`` to ``moved``, one behind the other.

    Part i begins at the index ``begins[i]`` of ``logs``, and has ``lengths[i]`` bytes.
    """
    to = 0
    for run in range(len(lengths)):
        for at in range(begins[run], begins[run] + lengths[run]):
            moved[to] = logs[at]
            to += 1


@entry
def play(handed, shared, order, again):
    """Play runs; return the number of bytes of all logs, or -1 if there is no room for the logs.

    ``shared`` is the memory of the batch: the runs are read from it, and the logs are written to
    it.  ``order`` holds the numbers of the runs in the order of the play.  If ``again`` is set, the
    runs are played by the percepts of the first play, without a world.
    """
    at = int64(0)
    for run in order:
        shared.begins[run] = at
        at = _episode(handed, shared, run, again, at)
        if at < 0:
            return -1
    handed.beat[1] = 0
    return at


@inlined
def _episode(handed, shared, run, again, at):
    """Play a run; return the index after its log, or -1 if there is no room for its log.

    ``shared`` is the memory of the batch.  The log is written to ``shared.logs``, from index ``at``
    on; the returned index is also one of ``shared.logs``.
    """
    explorer, action, head, logs = handed.library, handed.action, shared.heads[run], shared.logs
    cost, shown, turn = 0, 0, 1
    # The address of the percepts of three bytes, and the offset of the present one.
    offset, sensed = int64(0), int64(0)
    if again:
        sensed = address_of(shared.percepts) + int64(shared.starts[run])
    else:
        sensed = address_of(shared.worlds) + run * shared.worlds.shape[1] + layout.DEGREE
    _sense(sensed + offset, handed.percept)
    handed.beat[0], handed.beat[1] = run, 1
    _begin(explorer, action, head)
    while True:
        turn += 1
        handed.beat[1] = turn
        if at + LONGEST_ENTRY > len(logs):
            return int64(-1)
        kind = action[0]
        if explorer.wrong:
            logs[at] = codes.BEYOND
            break
        if kind == names.MOVE:
            if cost == head[layout.RUN_BUDGET]:
                logs[at] = codes.OVER_BUDGET
                break
            degree, motion = byte_of(sensed, offset), int64(action[1])
            if motion < 0 or motion >= degree:
                motion %= degree
            logs[at] = motion
            at += 1
            if not again:
                offset = _arrival(sensed, offset, motion, degree)
            elif cost < head[layout.RUN_MOTIONS]:
                offset += 3
            else:
                # The first play ended here.
                logs[at] = codes.BEYOND
                break
            _sense(sensed + offset, handed.percept)
            cost += 1
        elif kind == names.CHECKPOINT and shown <= head[layout.RUN_BUDGET]:
            shown += 1
            behind = _publish(handed, logs, at, codes.SHOWN)
            if behind == at:
                break
            at = behind
        else:
            at = _end(handed, logs, at)
            break
        action[0] = action[1] = 0
        call(explorer.step, (explorer.state, explorer.percept, explorer.action))
    return at + 1


@inlined
def _sense(address, percept):
    """Read the percept whose three bytes are at the address; write the percept to ``percept``."""
    percept[0], percept[1] = byte_of(address, 0), byte_of(address, 1)
    percept[2] = byte_of(address, 2) - 1


@inlined
def _arrival(sensed, offset, motion, degree):
    """The offset of the percept that the robot gets after the motion ``motion``.

    The world of a run is a table of five bytes for each dart: FIRST, the first dart of its vertex;
    PARTNER, the other dart of its edge; and the percept of a robot that arrives by the dart, which
    is three bytes.  The offset of a percept is its address minus ``sensed``, the address of the
    percept of dart 0; so dart d has the offset ``5 * d``.

    ``offset`` is the offset of the percept before the motion, ``degree`` is the degree in that
    percept, and ``motion`` is less than ``degree``.
    """
    leaving = offset + layout.WIDE * motion
    if leaving >= layout.WIDE * (byte_of(sensed, offset + layout.FIRST - layout.DEGREE) + degree):
        leaving -= layout.WIDE * degree
    return layout.WIDE * byte_of(sensed, leaving + layout.PARTNER - layout.DEGREE)


@inlined
def _begin(explorer, action, head):
    """Begin a run: let the explorer read its first percept, and write its first action.

    The percept is in the explorer's memory already, and the explorer writes the action to
    ``action``.  ``head`` holds the numbers of the run, such as the number that the explorer is told
    before the start.
    """
    explorer.wrong = 0
    if explorer.choose:
        call(explorer.choose, (explorer.state, explorer.pick, explorer))
    action[0] = action[1] = 0
    told = int32(head[layout.RUN_TOLD])
    call(explorer.start, (explorer.state, explorer.percept, told, explorer.action))


@inlined
def _end(handed, logs, at):
    """Write the end of a log, with or without an answer; return the index of the last byte.

    The end is written to ``logs``, from index ``at`` on.  It follows from the explorer's last
    action: an answer, one checkpoint too many, or anything illegal.
    """
    kind = handed.action[0]
    if kind == names.ANSWER_READY:
        return max(at, _publish(handed, logs, at, codes.ANSWERED) - 1)
    if kind == names.CHECKPOINT:
        logs[at] = codes.SHOWN_TOO_OFTEN
    elif kind == names.AMBIGUOUS:
        # Only the Python judge can judge a quotient.
        logs[at] = codes.BEYOND
    else:
        logs[at] = codes.FAULT
    return at


@inner
def _publish(handed, logs, at, what):
    """Write a checkpoint or an answer to ``logs`` from index ``at`` on; return the index after it.

    ``what`` is the first byte of the entry: SHOWN for a checkpoint, ANSWERED for an answer.  The
    explorer's map follows.  The entry cannot be written in two cases: the number of darts is not
    from 1 to MOST_DARTS, or some other number of the map does not fit into a byte.  Then the byte
    BEYOND at index ``at`` ends the log, which only the Python judge can judge; and the function
    returns ``at``, by which the caller sees that the log has ended.
    """
    explorer, here = handed.library, handed.here
    here[0] = NONE
    room = int32(explorer.room)
    arguments = explorer.state, room, explorer.sigma, explorer.alpha, explorer.here
    darts = int64(ask(explorer.answer, arguments))
    odd = darts < 1 or darts > codes.MOST_DARTS or here[0] < 0 or here[0] > 255
    if not odd:
        logs[at], logs[at + 1], logs[at + 2] = what, darts, here[0]
        for i in range(2 * darts):
            value = (
                entry_of(explorer.sigma, i) if i < darts else entry_of(explorer.alpha, i - darts)
            )
            odd |= value < 0 or value > 255
            logs[at + 3 + i] = value
    if odd:
        logs[at] = codes.BEYOND
        return at
    return at + 3 + 2 * darts


def pick(library, of, options, cost):  # pragma: no cover  # compiled
    """Return the index of the option that the policy chooses.

    The explorer calls this function as ``allworlds_pick``.  If the call is illegal,
    ``library.wrong`` is set to 1, and the returned index is 0.

    Args:
        library: the array ``LIBRARY`` of the explorer, which holds the policy.
        of: the number of the kind of choice, from 0 to 3; 0 is the choice of the dart that is
            explored next.
        options: the number of options, at least 1.
        cost: the address of the costs of the options, or 0.
    """
    taken = 0
    if options < 1 or of < 0 or of > 3:
        library.wrong = 1
    elif of == 0 and library.policy == names.LIFO:
        taken = options - 1
    elif of == 0 and library.policy == names.NEAREST and cost:
        for i in range(1, options):
            if entry_of(cost, i) < entry_of(cost, taken):
                taken = i
    return int32(taken)


@cache
def pick_address() -> int:
    """The address of the compiled :func:`pick`."""
    return callback(pick, types.int32(RECORD(LIBRARY), types.int32, types.int32, types.int64))
