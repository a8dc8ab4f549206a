"""The choice between the two judges of a unit: the judge in Python, and the compiled judge.

The compiled judge is the judge in compiled code; it judges units of large levels.
"""

from functools import partial
from random import Random
from typing import TYPE_CHECKING

from allworlds.engines import units
from allworlds.engines.batch import Judge, RunBatch
from allworlds.engines.judge import PythonJudge

if TYPE_CHECKING:
    from allworlds.engines.compiled_judge import CompiledJudge

SMALL = 3
"""The largest number of edges of the worlds in which both judges judge every log."""


class Judges:
    """The judges of a lane.

    Args:
        python: the judge in Python.
        random: the generator of the seeds that :class:`CompiledJudge` needs.
        native: whether the explorer is a shared library.
        compiles: whether this lane starts the compiler; of all lanes of a job only one does.
    """

    def __init__(
        self, python: PythonJudge, random: Random, *, native: bool, compiles: bool
    ) -> None:
        self.python = python
        self._native, self._seed = native, partial(random.getrandbits, 63)
        self._may_compile = compiles
        self._compiled: CompiledJudge | None = None
        self._small: list[RunBatch] = []

    def of(self, unit: units.UnitOfRuns) -> Judge:
        """The judge for a unit: the compiled judge, or the judge in Python.

        Let N be ``counter.compiled_from``.  The compiled judge judges the unit if three conditions
        hold: N is not None; the level of the unit or the next level of the check has at least N
        worlds; and the compiled judge is compiled already.  If N is 0, this method waits until it
        is compiled; else the judge in Python goes on meanwhile.  When the compiled judge is used
        for the first time, both judges are compared.

        Raises:
            EnginesDisagree: if the two judges count differently.
        """
        counter = self.python.counter
        least = counter.compiled_from
        if least is None or not isinstance(unit, units.LevelUnit):
            return self.python
        extent = counter.scope.extent
        following = min(unit.edges + 1, extent.levels[-1])  # the compiled judge is kept for them
        if max(units.level_size(extent, edges) for edges in (unit.edges, following)) < least:
            return self.python
        if self._compiled is None and (least == 0 or self._is_compiled()):
            from allworlds.engines.compiled_judge import CompiledJudge

            self._compiled = CompiledJudge(self.python, self._seed, native=self._native)
            self._compiled.compare_with(self._small)
            self._small.clear()
        return self._compiled or self.python

    def _is_compiled(self) -> bool:
        """Whether the code of the compiled judge is kept on disk, and so can be loaded quickly.

        If the code is not kept, and this lane may start the compiler, another process is started
        that compiles the code.
        """
        from allworlds.engines.compiled_engine import compile_apart, is_kept

        kept = is_kept()
        if not kept and self._may_compile:
            self._may_compile = False
            compile_apart()
        return kept

    def remember(self, batch: RunBatch) -> None:
        """Remember a batch if its worlds are small, to compare both judges on its logs later.

        Worlds are small if they have at most :data:`SMALL` edges.
        """
        unit = batch.work.unit
        wanted = self._compiled is None and self.python.counter.compiled_from
        if wanted and isinstance(unit, units.LevelUnit) and unit.edges <= SMALL:
            self._small.append(batch)
