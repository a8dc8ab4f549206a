"""The maps of a unit, judged under every schedule: the door to compiled code."""

from __future__ import annotations

import mmap
from collections.abc import Sequence
from typing import Any

from numpy import asarray, int32, int64, zeros
from typing_extensions import override

from allworlds.engines.kernel import every_schedule
from allworlds.engines.kernel.batches import LaidOutRuns, UnitJudge, any_level, no_player
from allworlds.engines.kernel.compiling import uncollected
from allworlds.engines.kernel.memory_arrays import StretchArrays
from allworlds.engines.kernel.records import SCHEDULES, new
from allworlds.engines.kernel.rows import Level
from allworlds.engines.kernel.stretch import HEAD, LONGEST_STRETCH, Stretch


class ScheduleJudge(UnitJudge):
    """The maps of a unit, each run of which has a log for every schedule.

    A stretch is judged portion by portion, since a run may have more schedules than there is room.
    """

    every = True

    def __init__(
        self, level: Level, prefix: Sequence[int], keep: int, stretch: Stretch, records: Stretch
    ) -> None:
        super().__init__(level, prefix, keep, stretch, records)
        self._now = new(SCHEDULES)
        self._broken = zeros(keep, int64)
        self._dearest, self._best = zeros((2, level.edges + 2), int64)

    @override
    def lay_out(self, most: int) -> LaidOutRuns:
        self._now.done = 0
        return super().lay_out(most)

    @override
    def is_done(self, batch: LaidOutRuns) -> bool:
        return super().is_done(batch) and self._now.stage == every_schedule.BETWEEN_RUNS

    @property
    @override
    def next(self) -> tuple[int, tuple[int, ...]]:
        inside = self._now.stage == every_schedule.INSIDE_A_RUN
        script = asarray(self._now.script)[: self._now.due].tolist() if inside else ()
        return int(self._now.done), tuple(script)

    @override
    def skip(self, batch: LaidOutRuns) -> None:
        self._job.until = batch.until
        asked = self._asked
        every_schedule.leave_out(self._job, self._now, self._prefix, self._viable, asked.counts)

    @override
    def _examine(self, batch: LaidOutRuns) -> tuple[Any, bool]:
        reader, asked = self._reader, self._asked
        heads = zeros((LONGEST_STRETCH, HEAD), int32)
        first = self._counted_until()
        self._best[:] = -1
        *arguments, _, beat = asked.arguments
        told = heads, self._dearest, self._best
        every_schedule.examine_schedules(self._job, reader, self._now, *arguments, beat, *told)
        places = asked.least[:, 1 + 4 * self._level.edges]
        self._broken[:] = places & (1 << every_schedule.ROW_BITS) - 1
        places >>= every_schedule.ROW_BITS
        self.counted = range(first, self._counted_until())
        # Choices that are not due are strange: then the last log does not count.
        return heads[: reader.run], True

    def _counted_until(self) -> int:
        """The number of the first run that has not been counted."""
        return int(self._job.number + (self._now.stage == every_schedule.INSIDE_A_RUN))

    @override
    def choices_of_broken(self, number: int) -> tuple[int, ...]:
        return self.kept(int(self._broken[number])).choices

    def choices_of_dearest(self, vertices: int) -> tuple[int, ...]:
        """The choices of the episode that costs most among those of that size in this portion."""
        return self.kept(int(self._dearest[vertices])).choices

    @property
    def best(self) -> dict[int, int]:
        """By vertices the largest cost of the cheapest schedule, of runs that are done."""
        return {n: cost for n, cost in enumerate(self._best.tolist()) if cost >= 0}


def load_every_schedule() -> None:
    """Load or compile the code that every schedule of native explorers needs."""
    level = any_level()
    with uncollected():
        stretch = StretchArrays(mmap.mmap(-1, Stretch.size(level.edges)), level.edges)
        judge = ScheduleJudge(level, (-1,), 1, stretch, stretch)
        batch = judge.lay_out(0)
        judge.judge(batch, 0)
        judge.skip(batch)
        no_player().play_schedules(stretch, 0, 0, (), 0)
