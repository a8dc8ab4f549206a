"""The judge in compiled code, which knows some of the laws; the judge in Python knows all.

Both judges read the same logs.  A lane keeps all logs of the smallest worlds.  When the lane loads
the compiled judge, both judges judge these logs, and then the logs of the first batch, and must
have equal counts.  If the compiled judge finds a broken law, the judge in Python judges the same
log again, and only the judge in Python makes the finding.
"""

from array import array
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from typing import Any

from allworlds.engines.batch import Due, Indices, Judged, Message, RunBatch, Work
from allworlds.engines.compiled_engine import compare, level_of, tally_of
from allworlds.engines.judge import PythonJudge
from allworlds.engines.kernel import arrays
from allworlds.engines.kernel.engine import LaidOutRuns, UnitJudge
from allworlds.engines.players import Logs
from allworlds.engines.tally import EnginesDisagree, Tally
from allworlds.engines.units import LevelUnit
from allworlds.maps.combinatorial import Code, CombinatorialMap, rooted_code
from allworlds.world.world import World

LIBRARIES = 8
"""The factor by which a batch is larger if a shared library plays it."""


class CompiledBatch(RunBatch):
    """Some runs of a unit; compiled code has written them into arrays.

    The method :meth:`due` returns one of these runs as a Python object.

    Attributes:
        laid: a description of the batch: the number of its runs, and the range of the numbers that
            its runs have in the unit.
        heads: for each run some numbers, such as its number, its place and its step budget.
        tables: for each run the table of its world, with a row of numbers for each dart.
    """

    def __init__(
        self, judge: "CompiledJudge", work: Work, unit_judge: UnitJudge, laid: LaidOutRuns
    ) -> None:
        assert isinstance(work.unit, LevelUnit)
        super().__init__(judge, work, ())
        self.unit, self.unit_judge, self.laid = work.unit, unit_judge, laid
        self.plain = not judge.native
        self.heads, self.tables = unit_judge.heads.copy(), unit_judge.worlds[: laid.runs].copy()
        self.percepts, self.starts = b"", array("i")
        self.motioned: Any = None

    def __len__(self) -> int:
        return self.laid.runs

    def due(self, index: int) -> Due:
        """The run of this index as a Python object; its map is made from ``tables[index]``."""
        table = self.tables[index].reshape(-1, arrays.WIDE).tolist()
        sigma = [first + (d + 1 - first) % deg for d, (first, _, deg, *_) in enumerate(table)]
        map_ = CombinatorialMap(sigma, [dart[arrays.PARTNER] for dart in table])
        number, place = self.heads[index, [arrays.RUN_NUMBER, arrays.RUN_PLACE]].tolist()
        lighthouse = [*self.by.counter.scope.rules.kind.places(map_, 0)][place]
        return Due(number, place, World(map_, lighthouse, 0))


class CompiledJudge:
    """The judge in compiled code, for units of the class :class:`LevelUnit`.

    Args:
        python: the judge in Python, with which this judge is compared.
        seed: the function that draws a seed for the order in which a shared library plays the runs.
        native: whether the explorer is a shared library; then compiled code also plays it.
    """

    every = False

    def __init__(self, python: PythonJudge, seed: Callable[[], int], *, native: bool) -> None:
        self.python, self.counter, self.rules = python, python.counter, python.rules
        self.seed, self.native = seed, native
        self._memories: dict[int, tuple[arrays.Stretch, arrays.Stretch]] = {}
        self.judged, self._compared = python.judged, False

    def batches(self, work: Work, size: Callable[[], int]) -> Iterator[CompiledBatch]:
        """Yield the runs of a unit in batches.

        ``work`` is the unit, and ``size`` is a function that returns about how many runs the next
        batch shall have.  If the explorer is a shared library, the batch is larger by the factor
        :data:`LIBRARIES`.
        """
        unit = work.unit
        assert isinstance(unit, LevelUnit)
        scope, edges = self.counter.scope, unit.edges
        if edges not in self._memories:
            self._memories[edges] = arrays.Stretch.of(edges), arrays.Stretch.of(edges)
        level = level_of(self.python.referee.explorer, scope.rules, scope.extent, edges)
        unit_judge = UnitJudge(level, unit.prefix, self.counter.keep, *self._memories[edges])
        last = False
        while not last:
            laid = unit_judge.lay_out(size() * (LIBRARIES if self.native else 1))
            last = laid.last
            batch = CompiledBatch(self, work, unit_judge, laid)
            if laid.runs:
                yield batch
            elif laid.until > laid.first:  # only worlds without a place are left in the unit
                self._by_python(batch)
                work.tally.add(batch.tally)

    def judge(self, batch: RunBatch) -> bool:
        """Judge the runs of a batch by the logs of their first play, and count the runs.

        The caller must give the batches in the order in which they were made, since the kernel
        makes their maps again in this order.  Return False if compiled code could not write all
        logs of a shared library; then the player must play these runs again in Python.
        """
        assert isinstance(batch, CompiledBatch)
        if self.native and batch.plain:
            self._by_python(batch)
            return True
        sums, good = self._sums(batch)
        if not good:
            if not self.native:
                self._by_python(batch)
            return not self.native
        tally = tally_of(sums, batch.unit, self.counter.scope, self.counter.tally())
        if not self._compared and batch.logs[0]:
            self._compared = True
            compare(tally, sums, self._python_tally(batch), batch.unit)
        batch.tally.add(tally)
        for broken in sums.broken:
            batch.broken.append(self._index_of(batch, (broken.sigma, broken.alpha), broken.place))
            law = batch.outcome(batch.broken[-1]).outcome.violation
            unknown = broken.law == "illegal-action"  # Python tells why a run has no answer
            if law is None or (law.law != broken.law and not unknown):
                raise EnginesDisagree(
                    f"the kernel says that {broken.law} is broken, the python engine that "
                    f"{law.law if law else 'none'} is, in the world sigma={list(broken.sigma)} "
                    f"alpha={list(broken.alpha)} place={broken.place}"
                )
        return True

    def _sums(self, batch: CompiledBatch) -> tuple[arrays.Sums, bool]:
        """The kernel's counts of a batch, and whether the kernel could judge all of its logs."""
        stretch, replay = self._memories[batch.unit.edges]
        given = batch.logs[0]
        in_order = [given[i] for i in sorted(given)] if isinstance(given, dict) else given
        logs = Logs.of(in_order)
        size = stretch.put(logs)
        unit_judge = batch.unit_judge
        unit_judge.heads = batch.heads
        sums, good = unit_judge.judge(batch.laid, size)
        count = len(logs)
        starts = [*replay.starts[:count].tolist(), unit_judge.noted]
        batch.percepts = replay.percepts[: unit_judge.noted].tobytes()
        batch.starts, batch.motioned = array("i", starts), replay.heads[:count].copy()
        return sums, good

    def _by_python(self, batch: CompiledBatch) -> None:
        """Let the Python judge judge and count a batch, in place of compiled code.

        This is done in three cases: compiled code cannot read a log of the batch; Python has played
        the runs of a shared library; or the batch has no run, but only worlds in which the
        lighthouse has no place, which are counted.
        """
        batch.tally.add(self._python_tally(batch))
        batch.broken.extend(
            index for index in range(len(batch)) if batch.outcome(index).outcome.violation
        )
        batch.plain, batch.percepts = True, b""

    def _python_tally(self, batch: CompiledBatch) -> Tally:
        """The tally that the Python judge makes of the logs of this batch."""
        tally, laid, index = self.counter.tally(), batch.laid, 0
        runs = islice(self.counter.runs(batch.unit, laid.first), laid.until - laid.first)
        for run in runs:
            world = self.counter.count_run(run, tally)
            if world is not None:
                self.counter.count_outcome(world, run.place, batch.outcome(index).outcome, tally)
                index += 1
        return tally

    def _index_of(self, batch: CompiledBatch, code: Code, place: int | None) -> int:
        """The index, in the batch, of the run with this place in the map with this canonical code.

        The type of ``place`` is that of a field of the kernel's results.  It is never None here:
        the kernel gives no place only if it walks each map once, and it does not do so for logs.

        Raises:
            EnginesDisagree: if the batch has no such run.
        """
        for index, head in enumerate(batch.heads.tolist()):
            if head[arrays.RUN_PLACE] == place:
                map_ = batch.due(index).world.map
                if rooted_code(map_.sigma, map_.alpha, 0) == code:
                    return index
        raise EnginesDisagree(f"the kernel has met a world that is none: {code}")

    # ---------------------------------------------------------------- messages

    def worlds(self, batch: RunBatch, indices: Indices) -> Message:
        """The message that tells a player to play these runs of the batch in their worlds."""
        assert isinstance(batch, CompiledBatch)
        if not batch.plain:
            whole = len(indices) == len(batch)
            laid = batch.heads, batch.tables
            heads, tables = (each if whole else each[[*indices]] for each in laid)
            return self._native(batch, indices, heads) | {"again": False, "worlds": tables}
        packed = (batch.tables[index].tobytes() for index in indices)
        return self.python.message("table", _entries(batch, indices, packed))

    def percepts(self, batch: RunBatch, indices: Indices, order: Indices = ()) -> Message:
        """The message that tells a player to play these runs of the batch by their percepts.

        The message holds no world.  ``order`` is the order of the play, as positions in
        ``indices``; if ``order`` is empty, the runs are played in the order of ``indices``.  But if
        compiled code plays the whole batch, it draws an order of its own.
        """
        assert isinstance(batch, CompiledBatch)
        if len(indices) == len(batch) and not batch.plain:
            again = {"again": True, "percepts": batch.percepts, "starts": batch.starts}
            return self._native(batch, indices, batch.motioned) | again
        if not batch.percepts:  # the Python judge has judged them
            return self.python.percepts(batch, indices, order)
        sensed = (batch.percepts[batch.starts[i] : batch.starts[i + 1]] for i in indices)
        return self.python.message("record", _entries(batch, indices, sensed), order)

    def _native(self, batch: CompiledBatch, indices: Indices, heads: Any) -> Message:
        return {
            "kind": "native",
            "edges": batch.unit.edges,
            "runs": len(indices),
            "seed": self.seed(),
            "policy": self.rules.policy,
            "heads": heads,
        }

    # ---------------------------------------------------------------- its twin

    def compare_with(self, batches: Iterable[RunBatch]) -> None:
        """Compare the counts of both judges for batches that the Python judge has judged.

        Raises:
            EnginesDisagree: if the two judges count differently.
        """
        units: dict[str, tuple[Work, dict[int, tuple[bytes, Judged]]]] = {}
        for batch in batches:
            _, known = units.setdefault(batch.work.unit.key, (batch.work, {}))
            for index, due in enumerate(batch.runs):
                known[due.number] = batch.logs[0][index], batch.outcome(index)
        for work, known in units.values():
            whole = Work(work.unit, self.counter.tally())
            for batch in self.batches(whole, lambda: 1 << 10):
                numbers = batch.heads[:, arrays.RUN_NUMBER].tolist()
                if not all(number in known for number in numbers):
                    break
                batch.logs[0] = [known[number][0] for number in numbers]
                batch.judged = {index: known[number][1] for index, number in enumerate(numbers)}
                self._compared = False
                self.judge(batch)
        self._compared = False


def _entries(
    batch: CompiledBatch, indices: Indices, around: Iterable[bytes]
) -> list[tuple[Any, ...]]:
    """The entries of a message to a player, one for each run.

    Each entry is a tuple of six values, as the player reads it: the world or the percepts; the
    number that the lighthouse tells before the start, or None; whether the task has ended the run,
    here always False; the step budget; the name of the run and the script of its choices, which are
    empty here.

    Args:
        batch: the batch.
        indices: the indices of the runs in the batch.
        around: for each run the world, or the percepts, as bytes.
    """
    said = batch.heads[[*indices]][:, [arrays.RUN_BUDGET, arrays.RUN_TOLD]].tolist()
    return [
        (world, None if number < 0 else number, False, budget, "", ())
        for world, (budget, number) in zip(around, said, strict=True)
    ]
