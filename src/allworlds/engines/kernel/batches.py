"""Batches of runs of a user's explorer: laid out and judged here, played in other processes.

The runs are laid out first, so that a player needs no enumeration, and can take the runs in any
order.  A library plays in :mod:`allworlds.engines.kernel.library_player`.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from allworlds.engines.kernel import engine, records as layout, runs
from allworlds.engines.kernel.compiling import entry
from allworlds.engines.kernel.gluing import advance
from allworlds.engines.kernel.instructions import call
from allworlds.engines.kernel.records import JOB, LOG_BYTES, NONE, READER, ROBOT, Stretch, new
from allworlds.engines.kernel.rows import Level, Rows
from allworlds.engines.kernel.worlds import settle


class LaidOutRuns(Struct, frozen=True):
    """A batch that has been laid out.

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
    """The maps of a unit, laid out and judged batch by batch.

    Args:
        level, prefix: as for :func:`allworlds.engines.kernel.engine.judge`.
        keep: the number of broken runs that are kept of each batch.
        stretch: the memory for the first play.
        records: for the second.
    """

    def __init__(
        self, level: Level, prefix: Sequence[int], keep: int, stretch: Stretch, records: Stretch
    ) -> None:
        self._stretch, self._records, self.worlds, self.noted = stretch, records, stretch.worlds, 0
        self._ahead, self._job, self._robot = new(JOB), new(JOB), new(ROBOT)
        for job in (self._ahead, self._job):
            engine.set_up(job, self._robot, level)
        self._unit = engine.unit_of(level, prefix, keep)
        self._reader = reader = new(READER)
        reader.logs, reader.begins = stretch.logs.ctypes.data, stretch.begins.ctypes.data
        reader.percepts, reader.starts = records.percepts.ctypes.data, records.starts.ctypes.data

    def lay_out(self, most: int) -> LaidOutRuns:
        """Write the next batch, of about that many runs, to the memory; return its bounds."""
        ahead, stretch = self._ahead, self._stretch
        first = int(ahead.number)
        ahead.until = first + min(most, layout.LONGEST_STRETCH)
        placed = lay_out(ahead, self._unit, stretch.heads, stretch.worlds)
        self.heads = stretch.heads[:placed].copy()
        return LaidOutRuns(placed, first, int(ahead.number), int(ahead.until) == 0)

    def judge(self, batch: LaidOutRuns, size: int) -> tuple[Rows, bool]:
        """Judge the logs in the memory; return the rows, and whether all logs could be judged.

        The percepts for the second play are written to its memory.

        Args:
            batch: that these are the logs of.
            size: of the logs, in bytes.
        """
        reader, job, unit, count = self._reader, self._job, self._unit, batch.runs
        reader.size = max(0, min(size, LOG_BYTES))
        reader.noted = reader.run = reader.strange = 0
        job.until = batch.until
        for results in (unit.met, unit.counts, unit.kept.most_expensive, unit.kept.least):
            results[:] = 0
        runs.examine(job, reader, unit, engine.flag())
        starts, heads = self._records.starts, self._records.heads[:count]
        starts[count] = self.noted = int(reader.noted)
        self.heads[:, layout.RUN_MOTIONS] = (starts[1 : count + 1] - starts[:count]) // 3 - 1
        heads[:] = self.heads
        heads[:, layout.RUN_NUMBER] = 0  # who plays again is not to know which runs these are
        good = reader.run == count and reader.strange == 0 and job.undefined == 0
        rows = engine.rows_of(unit, job, self._robot)
        return rows, good


@entry
def lay_out(job, unit, heads, worlds):
    """Lay out runs up to ``job.until``, or till there is no more room; return their number.

    The first two are as for :func:`allworlds.engines.kernel.runs.examine`; ``job.number`` becomes
    the number of the next run, and ``job.until`` 0 behind the last.  ``heads`` and ``worlds`` are
    written, a row for each run.
    """
    g, world, placed = job.gluing, job.world, 0
    while job.number < job.until and placed <= len(heads) - 2 * layout.MOST_PLACES:
        if not advance(g, unit.prefix, unit.viable):
            job.until = 0
            break
        settle(world, g)
        call(job.lighthouse, (world,))
        if world.place == NONE:
            job.number += 1
        while world.place != NONE:
            head, row = heads[placed], worlds[placed]
            head[layout.RUN_BUDGET] = unit.budgets[world.vertices]
            head[layout.RUN_TOLD], head[layout.RUN_NUMBER] = world.told, job.number
            for dart in range(world.darts):
                at = layout.WIDE * dart
                row[at + layout.FIRST] = world.first[dart]
                row[at + layout.PARTNER] = world.alpha[dart]
                row[at + layout.DEGREE] = world.degree[dart]
                row[at + layout.MARKS] = world.marks[dart]
                row[at + layout.BEARING] = world.bearing[dart] + 1
            placed += 1
            job.number += 1
            call(job.lighthouse, (world,))
    return placed
