"""Runs of large worlds that are played again at the end, under six further hash seeds."""

from random import Random

from allworlds.engines.batch import SECOND, RunBatch, Work
from allworlds.engines.hash_seeds import SIX_MORE
from allworlds.engines.judges import SMALL
from allworlds.engines.settling import Settler
from allworlds.engines.tally import Tally
from allworlds.log import Log

KEPT = 64
"""The largest number of runs that are played under six further seeds."""


class MoreSeeds:
    """Some runs of the largest worlds, which are kept until they are played under further seeds.

    Args:
        settler: the finder of runs that break a law, with the players of the lane.
        random: the generator of the random orders in which the runs are played.
        wanted: whether any runs are to be kept; if not, :meth:`keep` does nothing.
    """

    def __init__(self, settler: Settler, random: Random, *, wanted: bool) -> None:
        self._settler, self._random, self._wanted = settler, random, wanted
        self._kept: list[tuple[RunBatch, int]] = []

    def __bool__(self) -> bool:
        return bool(self._kept)

    def keep(self, batch: RunBatch) -> None:
        """Keep runs of a batch if its worlds are of the last level and have over ``SMALL`` edges.

        At most :data:`KEPT` runs are kept in all.
        """
        levels = self._settler.judge.counter.scope.extent.levels
        wanted = self._wanted and len(self._kept) < KEPT
        edges = batch.due(0).world.map.edge_count if wanted else 0
        if edges > SMALL and edges == levels[-1]:
            self._kept += [(batch, index) for index in range(len(batch))][: KEPT - len(self._kept)]

    def end(self) -> Tally:
        """Play the kept runs under further seeds, up to the first seed under which a log differs.

        A log differs if its walk or its answer is not that of the run's first play.  Then further
        plays of this run show why, and the returned tally holds the finding, the remark, or both.
        If no log differs, the returned tally is empty.  The tally counts no runs.
        """
        judge = self._settler.judge
        kept, self._kept = self._kept, []
        work = Work(kept[0][0].work.unit, judge.counter.tally())
        runs = [batch.record(index) for batch, index in kept]
        for seed in SIX_MORE:
            order = self._random.sample(range(len(runs)), len(runs))
            logs, lost = self._settler.plays.anew(seed, judge.percepts_message(runs, order))
            # A loss is not settled here: the other players meet it, too.
            for (batch, index), log in () if lost else zip(kept, logs, strict=True):
                if self._settler.differ(batch.outcome(index).log, Log(log)):
                    batch.work, self._wanted = work, False
                    self._settler.explain_under(seed, batch, [(index, Log(log))], SECOND)
                    return work.tally
        return work.tally
