"""Runs of a native explorer, many at a time: laid out and judged here, played in other processes.

:class:`Stretch` is what one process hands to another: memory that both see.  :class:`UnitJudge` lays out
and judges, and has no explorer; :class:`Actors` is the explorer's side.  What stands in the memory that
is shared with foreign code is copied before it is looked at, and is looked at as what it may be.
"""

from __future__ import annotations

import ctypes
import mmap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from numpy import array, asarray, frombuffer, int32, int64, ndarray, uint8, zeros
from numpy.random import default_rng

from allworlds.kernel import native, runs
from allworlds.kernel.engine import asked_of, rows_of, set_up
from allworlds.kernel.names import POLICIES
from allworlds.kernel.records import JOB, POLICY, READER, ROBOT, new
from allworlds.kernel.rows import Level, Rows

LONGEST_STRETCH = 4096
"""The largest number of runs in a stretch, but for those of its last world."""

LOG_BYTES = 1 << 21
"""Room for the logs of a stretch, and as much for its percepts: 512 bytes a run."""


class Stretch:
    """Memory for so many runs, as both sides see it.

    Args:
        memory: shared; of :meth:`size` bytes.
        edges: of each world.

    Attributes:
        heads: of each run its budget, what is told, its number, and how many motions it had.
        worlds: of each run its world, dart by dart; for who plays against records there is none.
        percepts, starts: what was sensed, three bytes each, and where those of a run begin.
        logs, begins: what was done, and where the log of each run begins.
    """

    def __init__(self, memory: mmap.mmap, edges: int) -> None:
        rows = LONGEST_STRETCH + native.MOST_PLACES
        self._at = 0
        self._memory = memory
        self.heads = self._array(int32, rows, native.HEAD)
        self.begins = self._array(int32, rows)
        self.starts = self._array(int32, rows)
        self.worlds = self._array(uint8, rows, native.WIDE * 2 * edges)
        self.percepts = self._array(uint8, LOG_BYTES)
        self.logs = self._array(uint8, LOG_BYTES)

    @staticmethod
    def size(edges: int) -> int:
        """The number of bytes."""
        rows = LONGEST_STRETCH + native.MOST_PLACES
        return rows * (4 * native.HEAD + 8 + native.WIDE * 2 * edges) + 2 * LOG_BYTES

    def _array(self, kind: Any, *shape: int) -> Any:
        count = 1
        for length in shape:
            count *= length
        found: Any = frombuffer(self._memory, kind, count, self._at).reshape(shape)
        self._at += found.nbytes
        return found


@dataclass(frozen=True, slots=True)
class Laid:
    """A stretch that has been laid out.

    Attributes:
        runs: how many.
        first, until: the numbers of its first run and of that after its last, in their unit.
        last: there is no other behind it.
    """

    runs: int
    first: int
    until: int
    last: bool


class UnitJudge:
    """The maps of a unit, laid out and judged stretch by stretch.

    Args:
        level, prefix: as for :func:`allworlds.kernel.judge`.
        keep: how many broken runs are kept of each stretch.
        stretch: for the first play.
        records: for the second.
    """

    def __init__(
        self, level: Level, prefix: Sequence[int], keep: int, stretch: Stretch, records: Stretch
    ) -> None:
        self._level, self._stretch, self._records = level, stretch, records
        self._ahead, self._job, robot = _room()
        self._reader = new(READER)
        for job in (self._ahead, self._job):
            set_up(job, robot, level)
        explorer = self._job.explorer
        explorer.start, explorer.step, explorer.answer = native.reader_addresses()
        explorer.first = asarray(self._reader).ctypes.data
        self._robot = robot
        self._asked = asked_of(level, prefix, keep)
        self._prefix, self._viable, _, _, self._budgets, *_ = self._asked.arguments
        self._never = zeros(1, int64)

    def lay_out(self, most: int) -> Laid:
        """The next stretch, of about so many runs; it comes to stand in the memory."""
        ahead, stretch = self._ahead, self._stretch
        first = int(ahead.number)
        ahead.until = first + min(most, LONGEST_STRETCH)
        lit = native.lay_out(
            ahead, self._prefix, self._viable, self._budgets, stretch.heads, stretch.worlds
        )
        self._heads = stretch.heads[:lit].copy()
        return Laid(lit, first, int(ahead.number), int(ahead.until) == 0)

    def skip(self, laid: Laid) -> None:
        """Go on behind a stretch that is judged elsewhere: what was said of it is forgotten."""
        if self._job.number < laid.until:
            self.judge(laid, 0)

    def judge(self, laid: Laid, size: int) -> tuple[Rows, bool]:
        """What the logs in the memory are worth, and whether all of them could be judged.

        The percepts for the second play come to stand in its memory.

        Args:
            laid: the stretch.
            size: of the logs, in bytes.
        """
        reader, job, asked = self._reader, self._job, self._asked
        stretch, records = self._stretch, self._records
        size = max(0, min(size, LOG_BYTES))
        self.logs, self.begins = stretch.logs[:size].copy(), stretch.begins[: laid.runs].copy()
        reader.logs, reader.size = self.logs.ctypes.data, size
        reader.begins = self.begins.ctypes.data
        percepts, starts = zeros(LOG_BYTES, uint8), zeros(laid.runs + 1, int32)
        reader.percepts, reader.room = percepts.ctypes.data, LOG_BYTES
        reader.ends, reader.noted = starts.ctypes.data, 0
        reader.run = reader.strange = 0
        job.until = laid.until
        asked.clear()
        self._robot.events[:] = 0
        runs.examine(job, *asked.arguments, self._never)
        starts[laid.runs] = reader.noted
        noted = int(reader.noted)
        records.percepts[:noted] = percepts[:noted]
        records.starts[: laid.runs] = starts[: laid.runs]
        self._heads[:, native.RUN_MOTIONS] = (starts[1:] - starts[:-1]) // 3 - 1
        records.heads[: laid.runs] = self._heads
        good = reader.strange == 0 and reader.run == laid.runs
        return rows_of(asked, job, self._robot), good and job.undefined == 0

    def differing(self, laid: Laid, size: int) -> list[int]:
        """The numbers of the runs whose second logs are not as their first ones."""
        records = self._records
        size = max(0, min(size, LOG_BYTES))
        logs, begins = records.logs[:size].copy(), records.begins[: laid.runs].copy()
        found = zeros(laid.runs, int64)
        count = native.differing(self.logs, self.begins, logs, begins, laid.runs, found)
        numbers: list[int] = self._heads[found[:count], native.RUN_NUMBER].tolist()
        return numbers


_ROOMS: list[tuple[Any, Any, Any]] = []


def _room() -> tuple[Any, Any, Any]:
    """This process's memory for two jobs, and for what counts nothing."""
    if not _ROOMS:
        _ROOMS.append((new(JOB), new(JOB), new(ROBOT)))
    return _ROOMS[0]


class Actors:
    """A native explorer that plays stretches.

    Args:
        addresses: of ``start``, ``step``, ``answer`` and ``choose`` (0: none), by name.
        state: the address of its state.
        arrays: percept, action, here, sigma and alpha: what is handed to it.
        beat: the number of the current run, and the explorer's turns in it.
    """

    def __init__(
        self, addresses: dict[str, int], state: int, arrays: Sequence[Any], beat: Any
    ) -> None:
        self._asked = new(POLICY)
        self._memory = arrays  # what is handed to the explorer must stay
        self._arrays = tuple(_view(each) for each in arrays)
        percept, action, here, sigma, alpha = (each.ctypes.data for each in self._arrays)
        self._beat = frombuffer(beat, int64)
        self._explorer = array(
            [
                *(addresses[name] for name in ("start", "step", "answer", "choose")),
                *(state, percept, action, sigma, alpha, here),
                *(native.pick_address(), asarray(self._asked).ctypes.data),
            ],
            int64,
        )

    def play(self, stretch: Stretch, laid: int, order: int, policy: str, *, again: bool) -> int:
        """The number of bytes of the logs of so many runs; -1 if there is no room for them.

        Args:
            stretch: in shared memory.
            laid: how many runs.
            order: seed of the order in which they are played.
            policy: answers its choices.
            again: against records.
        """
        self._asked.policy = POLICIES[policy]
        every = default_rng(order).permutation(laid).astype(int64)
        common = (self._explorer, *self._arrays, self._asked, stretch.heads)
        if again:
            said = (stretch.percepts, stretch.starts, every, stretch.logs, stretch.begins)
            return int(native.play_records(*common, *said, self._beat))
        shown = (stretch.worlds, every, stretch.logs, stretch.begins)
        return int(native.play_worlds(*common, *shown, self._beat))


def _view(memory: Any) -> ndarray[Any, Any]:
    """An array of C's integers as one of numpy."""
    address, length = ctypes.addressof(memory), ctypes.sizeof(memory) // 4
    return frombuffer((ctypes.c_int32 * length).from_address(address), int32)
