"""Runs of a native explorer, many at a time: laid out and judged here, played in other processes.

:class:`~allworlds.engines.kernel.stretch.Stretch` is memory that two processes see.
:class:`UnitJudge` lays out and judges, and has no explorer; :class:`NativePlayer` is the explorer's
side.  Memory that is shared with users' code is copied before it is read.
"""

from __future__ import annotations

import ctypes
import mmap
from collections.abc import Sequence
from typing import Any

from msgspec import Struct
from numpy import arange, array, asarray, frombuffer, int32, int64, uint8, zeros

from allworlds.engines.kernel import logs, native, runs, stretch as stretches
from allworlds.engines.kernel.compiling import uncollected
from allworlds.engines.kernel.engine import flag, rows_of, set_up, unit_of
from allworlds.engines.kernel.memory_arrays import StretchArrays
from allworlds.engines.kernel.names import POLICIES
from allworlds.engines.kernel.records import ASKED, JOB, READER, ROBOT, new
from allworlds.engines.kernel.rows import Level, LevelBounds, Rows
from allworlds.engines.kernel.stretch import LOG_BYTES, LONGEST_STRETCH, ROWS, Stretch
from allworlds.engines.kernel.tables import tables


class LaidOutRuns(Struct, frozen=True):
    """A stretch that has been laid out.

    Attributes:
        runs: the number of runs.
        first, until: the numbers of its first run and of that after its last, in their unit.
        last: whether it is the last one of its unit.
    """

    runs: int
    first: int
    until: int
    last: bool


class UnitJudge:
    """The maps of a unit, laid out and judged stretch by stretch.

    Args:
        level: as for :func:`allworlds.engines.kernel.engine.judge`.
        prefix: as for :func:`allworlds.engines.kernel.engine.judge`.
        keep: the number of broken runs that are kept of each stretch.
        stretch: for the first play.
        records: for the second.
    """

    def __init__(
        self, level: Level, prefix: Sequence[int], keep: int, stretch: Stretch, records: Stretch
    ) -> None:
        self._stretch, self._records, self.noted = stretch, records, 0
        self._ahead, self._job, self._robot = new(JOB), new(JOB), new(ROBOT)
        for job in (self._ahead, self._job):
            set_up(job, self._robot, level)
        self._unit = unit_of(level, prefix, keep)
        self._reader = reader = new(READER)
        reader.logs, reader.percepts = _FIRST_LOGS.ctypes.data, _PERCEPTS.ctypes.data
        reader.begins, reader.ends, reader.starts = (
            each.ctypes.data for each in (_BEGINS, _ENDS, _STARTS)
        )
        reader.room = LOG_BYTES

    def lay_out(self, most: int) -> LaidOutRuns:
        """Write the next stretch, of about that many runs, to the memory; return its bounds."""
        ahead, stretch = self._ahead, self._stretch
        first = int(ahead.number)
        ahead.until = first + min(most, LONGEST_STRETCH)
        placed = native.lay_out(ahead, self._unit, stretch.heads, stretch.worlds)
        self.heads = stretch.heads[:placed].copy()
        return LaidOutRuns(placed, first, int(ahead.number), int(ahead.until) == 0)

    def skip(self, batch: LaidOutRuns) -> None:
        """Go on behind a stretch that is judged elsewhere, without its results."""
        if self._job.number < batch.until:
            self.judge(batch, 0)

    def judge(self, batch: LaidOutRuns, size: int) -> tuple[Rows, bool]:
        """Judge the logs in the memory; return the rows, and whether all logs could be judged.

        The percepts for the second play are written to its memory.

        Args:
            batch: the stretch.
            size: of the logs, in bytes.
        """
        reader, job, unit, count = self._reader, self._job, self._unit, batch.runs
        size = max(0, min(size, LOG_BYTES))
        _FIRST_LOGS[:size] = self._stretch.logs[:size]
        _BEGINS[:count] = self._stretch.begins[:count]
        reader.size = size
        reader.noted = reader.run = reader.strange = 0
        job.until = batch.until
        for results in (unit.met, unit.counts, unit.kept.most_expensive, unit.kept.least):
            results[:] = 0
        runs.examine(job, reader, unit, flag())
        _STARTS[count] = reader.noted
        self.heads[:, stretches.RUN_MOTIONS] = (_STARTS[1 : count + 1] - _STARTS[:count]) // 3 - 1
        self._hand_over()
        self.noted = int(reader.noted)
        good = reader.run == count and reader.strange == 0 and job.undefined == 0
        return rows_of(unit, job, self._robot), good

    def _hand_over(self) -> None:
        """Hand the percepts of these runs to the second player."""
        records, count = self._records, len(self.heads)
        end = min(int(_STARTS[count]), LOG_BYTES)
        records.percepts[:end] = _PERCEPTS[:end]
        records.starts[:count] = _STARTS[:count]
        records.heads[:count] = self.heads
        # Who plays again is not to know which runs these are.
        records.heads[:count, stretches.RUN_NUMBER] = 0


_FIRST_LOGS = zeros(LOG_BYTES + logs.SLACK, uint8)
"""This process's copy of the logs of a stretch."""

_PERCEPTS = zeros(LOG_BYTES, uint8)
"""The percepts on the walks of the first logs."""

_BEGINS, _ENDS, _STARTS = zeros((3, ROWS + 1), int32)
"""Where each of the first logs begins and ends, and where the percepts of its run begin."""


class NativePlayer:
    """A native explorer that plays stretches.

    Args:
        addresses: of ``start``, ``step``, ``answer`` and ``choose`` (0: none), by name.
        state: the address of its state.
        arrays: percept, action, here, and twice sigma and alpha, which are handed to it.
        beat: the number of the current run, and the explorer's turns in it.
    """

    def __init__(
        self, addresses: dict[str, int], state: int, arrays: Sequence[Any], beat: Any
    ) -> None:
        self._asked = new(ASKED)
        self._memory = arrays  # what is handed to the explorer must stay
        percept, action, here, *rooms = (_view(each) for each in arrays)
        self._asked.room = len(rooms[0])
        pointers = (
            *(addresses[name] for name in ("start", "step", "answer", "choose")),
            *(state, percept.ctypes.data, action.ctypes.data, here.ctypes.data),
            *(native.pick_address(), asarray(self._asked).ctypes.data),
            *(each.ctypes.data for each in rooms),
        )
        beat = frombuffer(beat, int64)
        self._handed = native.Handed(array(pointers, int64), percept, action, here, beat)

    def play(self, stretch: Stretch, count: int, order: int, policy: str, *, again: bool) -> int:
        """Play runs; return the number of bytes of their logs, or -1 if there is no room for them.

        Args:
            stretch: in shared memory.
            count: of the runs.
            order: seed of the order in which they are played.
            policy: answers its choices.
            again: whether they are played against records.
        """
        rows = arange(count)
        native.shuffle(rows, order)
        self._asked.policy = POLICIES[policy]
        shared = native.Shared(*(getattr(stretch, part) for part in native.Shared._fields))
        return int(native.play(self._handed, self._asked, shared, rows, again))


def _view(memory: Any) -> Any:
    """An array of C's integers as one of numpy."""
    address, length = ctypes.addressof(memory), ctypes.sizeof(memory) // 4
    array_of: Any = (ctypes.c_int32 * length).from_address(address)
    return frombuffer(array_of, int32)


def load_native() -> None:
    """Load or compile the code that native explorers need, but for the lighthouses."""
    level = any_level()
    with uncollected():
        stretch = StretchArrays(mmap.mmap(-1, Stretch.size(level.edges)), level.edges)
        unit = UnitJudge(level, (-1,), 1, stretch, stretch)
        batch = unit.lay_out(0)
        unit.judge(batch, 0)
        no_player().play(stretch, 0, 0, "fifo", again=False)


def any_level() -> Level:
    """A level whose maps have one edge."""
    return Level(
        1,
        2,
        simple=False,
        planar=False,
        explorer="",
        lighthouse="directional",
        policy="fifo",
        laws=(),
        bounds=LevelBounds(lambda *_: None),
        budgets=(0, 0, 0),
        tables=tables(1, 0),
    )


def no_player() -> NativePlayer:
    """A player without an explorer, which can play no run."""
    nothing = dict.fromkeys(("start", "step", "answer", "choose"), 0)
    handed = [(ctypes.c_int32 * length)() for length in (3, 2, 1, 1, 1, 1, 1)]
    return NativePlayer(nothing, 0, handed, bytearray(16))
