"""The judge in compiled code, of the laws that it knows; its twin judges in Python.

Both take the same logs.  They are compared on every log of the smallest worlds that a lane has seen
before it loads this one, and on its first batch.  A run in which this judge finds a law broken is
judged by the other one from the same bytes, and that alone makes the finding.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import islice
from typing import Any

from allworlds.engines.compiled_engine import level_of, tally_of
from allworlds.engines.judge import Due, Judged, PythonJudge, Recorded, RunBatch, Work
from allworlds.engines.kernel.batches import LaidOutRuns, UnitJudge
from allworlds.engines.kernel.records import (
    RUN_BUDGET,
    RUN_NUMBER,
    RUN_TOLD,
    Stretch,
)
from allworlds.engines.kernel.rows import Rows
from allworlds.engines.players import Logs
from allworlds.engines.scope import LevelRuns
from allworlds.engines.tally import EnginesDisagree, Tally
from allworlds.maps.canonical import Code, rooted_code
from allworlds.protocol.actions import Percept
from allworlds.protocol.playing import numbers_of, percept_of

LIBRARIES = 8
"""The batches of libraries are so many times as large."""


class CompiledBatch(RunBatch):
    """Some runs that compiled code has laid out; what Python needs of them is made when asked for.

    Attributes:
        laid: their bounds in the unit.
        heads, tables: of each run, as the kernel has laid them out.
    """

    def __init__(
        self, judge: CompiledJudge, work: Work, laid: LaidOutRuns, heads: Any, tables: Any
    ) -> None:
        super().__init__(judge.python, work, ())
        self.laid, self.heads, self.tables, self.plain = laid, heads, tables, not judge.native
        self.by: Any = judge
        self.percepts, self.starts = b"", array("i")
        self.unit_judge: UnitJudge
        self.motioned: Any = None
        self._found: list[int] = []
        self._known: dict[int, Judged] = {}

    def __len__(self) -> int:
        return self.laid.runs

    @property
    def runs(self) -> list[Due]:
        """The runs, as Python has them."""
        if not self._runs and len(self):
            unit, laid = self.work.unit, self.laid
            every = islice(self.by.engine.runs(unit, laid.first), laid.until - laid.first)
            self._runs = self.judge.due(every)
        return self._runs

    def worlds(self, rows: Sequence[int], *, hear: bool = False) -> dict[str, Any]:
        """The message to a player that plays these runs in their worlds."""
        if self.by.native and not (self.plain or hear):
            whole = len(rows) == len(self)
            heads, tables = (each if whole else each[[*rows]] for each in (self.heads, self.tables))
            return self._native(rows, heads) | {"again": False, "worlds": tables}
        told = self._told(rows, (self.tables[row].tobytes() for row in rows))
        return self.judge.message("table", told, range(len(rows)), hear=hear)

    def _told(self, rows: Sequence[int], places: Iterable[bytes]) -> list[tuple[Any, ...]]:
        """Rows of a message: worlds or records, and what is said of each run."""
        said = self.heads[[*rows]][:, [RUN_BUDGET, RUN_TOLD]].tolist()
        return [
            (place, None if number < 0 else number, False, budget, "", ())
            for place, (budget, number) in zip(places, said, strict=True)
        ]

    def records(self, rows: Sequence[int], order: Sequence[int]) -> dict[str, Any]:
        """The message to a player that plays recorded percepts."""
        whole = len(rows) == len(self) and not self.plain
        if self.by.native and whole:
            sensed = {"again": True, "percepts": self.percepts, "starts": self.starts}
            return self._native(rows, self.motioned) | sensed
        return self.judge.message("record", self._told(rows, map(self._percepts, rows)), order)

    def _native(self, rows: Sequence[int], heads: Any) -> dict[str, Any]:
        return {
            "kind": "native",
            "edges": self.work.unit.edges,  # type: ignore[attr-defined]
            "runs": len(rows),
            "seed": self.by.seed(),
            "policy": self.judge.rules.policy,
            "heads": heads,
        }

    def _percepts(self, row: int) -> bytes:
        return self.percepts[self.starts[row] : self.starts[row + 1]]

    def record(self, row: int) -> Recorded:
        """Return the record of a run: all that the second player gets of it."""
        sensed = self._percepts(row)
        percepts: list[Percept] = [
            percept_of(*sensed[at : at + 3]) for at in range(0, len(sensed), 3)
        ]
        return Recorded(percepts, self.runs[row].world)

    @property
    def without_words(self) -> list[int]:
        """The broken runs of which compiled code has written the log: without words or choices."""
        return self.broken if self.by.native and not self.plain else []

    def written_anew(self, row: int, log: bytes) -> None:
        """Take the log of a run that Python has played."""
        super().written_anew(row, log)
        self._known.pop(row, None)

    def outcome(self, row: int) -> Judged:
        """A run, judged by the Python judge."""
        if row not in self._known:
            self._known[row] = self.judge.judged(self.runs[row], self.logs[0][row])
        return self._known[row]

    @property
    def broken(self) -> list[int]:
        """The least of the runs that break a law."""
        return self._found

    def follow_ups(self) -> list[Due]:
        """Return no run: this judge knows one schedule alone."""
        return []


class CompiledJudge:
    """The judge of units of a level.

    Args:
        python: its twin.
        seed: draws seeds for the order in which a library plays.
        native: whether the explorer is a library, which compiled code plays, too.
    """

    every = False

    def __init__(self, python: PythonJudge, seed: Callable[[], int], *, native: bool) -> None:
        self.python, self.engine, self.rules = python, python.engine, python.rules
        self.seed, self.native = seed, native
        self._memories: dict[int, tuple[Stretch, Stretch]] = {}
        self._compared = False

    def batches(self, work: Work, size: Callable[[], int]) -> Iterator[CompiledBatch]:
        """The runs of a unit, so many at a time."""
        unit = work.unit
        assert isinstance(unit, LevelRuns)
        judge, (stretch, _) = self._unit(unit)
        last = False
        while not last:
            laid = judge.lay_out(size() * (LIBRARIES if self.native else 1))
            last = laid.last
            worlds = stretch.worlds[: laid.runs].copy()
            batch = CompiledBatch(self, work, laid, judge.heads.copy(), worlds)
            batch.unit_judge = judge
            if laid.runs:
                yield batch
            elif laid.until > laid.first:  # worlds without a place
                self.judge(batch)

    def _unit(self, unit: LevelRuns) -> tuple[UnitJudge, tuple[Stretch, Stretch]]:
        scope, edges = self.engine.scope, unit.edges
        if edges not in self._memories:
            self._memories[edges] = Stretch(edges), Stretch(edges)
        level = level_of(self.python.referee.explorer, scope.rules, scope.extent, edges)
        memories = self._memories[edges]
        return UnitJudge(level, unit.prefix, self.engine.keep, *memories), memories

    def judge(self, batch: CompiledBatch) -> bool:
        """Judge the first logs of a batch, and count them; those of one unit in their order.

        Return False if compiled code has written logs that only Python knows how to write.
        """
        unit, work = batch.work.unit, batch.work
        assert isinstance(unit, LevelRuns)
        if self.native and batch.plain:
            self._by_python(batch)
            return True
        rows, good = self._rows(batch)
        if not good:
            if not self.native:
                self._by_python(batch)
            return not self.native
        tally = tally_of(rows, unit, self.engine.scope, self.engine.tally())
        if not self._compared and batch.logs[0]:
            self._compared = True
            compare(tally, rows, self._python_tally(batch), unit)
        work.tally.add(tally)
        for broken in rows.broken:
            batch.broken.append(self._row(batch, (broken.sigma, broken.alpha), broken.place))
            law = batch.outcome(batch.broken[-1]).outcome.violation
            unknown = broken.law == "illegal-action"  # of a run without an answer Python knows why
            if law is None or (law.law != broken.law and not unknown):
                raise EnginesDisagree(
                    f"the kernel says that {broken.law} is broken, the python engine that "
                    f"{law.law if law else 'none'} is, in the world sigma={list(broken.sigma)} "
                    f"alpha={list(broken.alpha)} place={broken.place}"
                )
        return True

    def skip(self, batch: CompiledBatch) -> None:
        """Go on behind a batch that Python plays and judges."""
        batch.plain = True
        batch.unit_judge.skip(batch.laid)

    def _rows(self, batch: CompiledBatch) -> tuple[Rows, bool]:
        """The rows of a batch, and whether all logs could be judged."""
        edges = batch.work.unit.edges  # type: ignore[attr-defined]
        stretch, records = self._memories[edges]
        given = batch.logs[0]
        logs = Logs.of([given[row] for row in range(len(batch))] if type(given) is dict else given)
        size = stretch.put(logs)
        judge = batch.unit_judge
        judge.heads = batch.heads
        rows, good = judge.judge(batch.laid, max(0, size))
        count = len(logs)
        starts = [*records.starts[:count].tolist(), judge.noted]
        batch.percepts = records.percepts[: judge.noted].tobytes()
        batch.starts, batch.motioned = array("i", starts), records.heads[:count].copy()
        return rows, good and size >= 0

    def _by_python(self, batch: CompiledBatch) -> None:
        """Count a batch by the Python judge: there is something in its logs that is new here."""
        batch.work.tally.add(self._python_tally(batch))
        batch.broken.extend(
            row for row in range(len(batch)) if batch.outcome(row).outcome.violation
        )
        parts = [
            numbers_of(batch.outcome(row).outcome.episode.transcript.percepts)
            for row in range(len(batch))
        ]
        batch.plain, batch.starts = True, array("i", [0])
        for part in parts:
            batch.starts.append(batch.starts[-1] + len(part))
        batch.percepts = b"".join(map(bytes, parts))

    def _python_tally(self, batch: CompiledBatch) -> Tally:
        """Return the tally that the Python judge makes of the same logs."""
        tally, laid, row = self.engine.tally(), batch.laid, 0
        runs = islice(self.engine.runs(batch.work.unit, laid.first), laid.until - laid.first)
        for run in runs:
            if self.engine.count_run(run, tally) is not None:
                due, one = batch.runs[row], batch.outcome(row)
                self.engine.count_outcome(due.world, due.place, one.outcome, tally)
                row += 1
        return tally

    def _row(self, batch: CompiledBatch, code: Code, place: int | None) -> int:
        """The row of a run."""
        for row, due in enumerate(batch.runs):
            map_ = due.world.map
            if due.place == place and rooted_code(map_.sigma, map_.alpha, 0) == code:
                return row
        raise EnginesDisagree(f"the kernel has met a world that is none: {code}")

    def compare_with(self, batches: Iterable[RunBatch]) -> None:
        """Compare both judges on whole units of logs.

        Raises:
            EnginesDisagree: if they count differently.
        """
        units: dict[str, tuple[Work, dict[int, bytes]]] = {}
        for batch in batches:
            _, known = units.setdefault(batch.work.unit.key, (batch.work, {}))
            known.update({due.number: batch.logs[0][i] for i, due in enumerate(batch.runs)})
        for work, known in units.values():
            whole = Work(work.unit, self.engine.tally())
            for batch in self.batches(whole, lambda: 1 << 10):
                numbers = batch.heads[:, RUN_NUMBER].tolist()
                if not all(number in known for number in numbers):
                    break
                batch.logs[0] = [known[number] for number in numbers]
                self._compared = False
                self.judge(batch)
        self._compared = False


def compare(kernels: Tally, rows: Rows, pythons: Tally, unit: LevelRuns) -> None:
    """Raise EnginesDisagree unless both judges have counted the same."""
    if _counts_of(kernels) != _counts_of(pythons):
        raise EnginesDisagree(
            f"the kernel and the python engine count differently in the unit {unit.key}: "
            f"{_counts_of(kernels)} and {_counts_of(pythons)}; broken: {rows.broken}"
        )


def _counts_of(tally: Tally) -> object:
    """All that is counted of the runs of a unit."""
    sizes = sorted(tally.rows.items())
    most = [(size, row.most_expensive and row.most_expensive[:3]) for size, row in sizes]
    return [row for _, row in sizes], most, tally.left_out, tally.checkpoints, +tally.witnesses
