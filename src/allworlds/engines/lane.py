"""A lane: one judge with its two players, all of them at work at the same time.

    unit --> first player (in worlds) --> logs --> judge --> tally, findings
                                          second player (percepts only) --> the same logs?

The lane is the loop: it gives batches to the players, and receives the logs.  After the first play
of a batch the lane lets the batch be judged, and gives it to the second player; after the second
play it lets the batch be settled.  To *settle* a batch is to compare the two plays, and to find the
runs that break a law.  Other modules judge a batch (``judge``), settle it (``settling``,
``hash_seeds``), and define what a lost player means (``losses``).

An :class:`AcrossUnit` consists of all runs in small worlds.  Each of these runs also belongs to
another unit, in which it is played and counted as usual.  For the AcrossUnit two processes play all
of these runs, in two opposite orders (``across``).  The lane can often save one of these two plays:
if its first player has played all of these runs already, in Python and without a loss, the logs of
the first player are used.

The argument ``which`` of a method is the number of a player, FIRST or SECOND.
"""

import time
from collections import deque
from collections.abc import Sequence
from functools import partial
from random import Random

from allworlds.engines import hash_seeds, limits, losses, tally, units
from allworlds.engines.across import Across, AtPlace, FirstLog, remember
from allworlds.engines.batch import FIRST, SECOND, RunBatch, Work
from allworlds.engines.judge import PythonJudge
from allworlds.engines.judges import Judges
from allworlds.engines.more_seeds import MoreSeeds
from allworlds.engines.players import Lost, Setup, Unsettled, wait
from allworlds.engines.plays import DEPTH, BothPlays
from allworlds.engines.settling import Settler
from allworlds.explorers.loading import Subject

LEAST, MOST = 16, 256
"""The number of runs in the first batch, and the largest number in any batch."""


class Lane:
    """A judge with its players.

    Args:
        subject: the explorer.
        counter: the counter of the runs, which also holds the scope.
        limits: the limits of the time for an answer, and of memory.
        given: for a single run, the index of the option to be taken at each of the first choices;
            a single run is not played again under further hash seeds.  None for the runs of a
            check.
        seeds: the hash seeds of both players.
        first_lane: whether the lane has two further tasks: to start the compiler if the compiled
            judge is not compiled yet, and to play some runs under six further hash seeds.  False
            for all forked lanes but the first.
        deadline: the time, on the monotonic clock, after which the lane waits for no play; or None.

    Attributes:
        given_up: the reason why the lane has given up, because the explorer was silent in too many
            runs; empty if it has not given up.
    """

    def __init__(
        self,
        subject: Subject,
        counter: tally.RunCounter,
        limits: limits.Limits,
        *,
        given: tuple[int, ...] | None = None,
        seeds: hash_seeds.Seeds = (FIRST, SECOND),
        first_lane: bool = True,
        deadline: float | None = None,
    ) -> None:
        self.counter, self.given_up = counter, ""
        self._twice = subject.from_user
        random = Random()  # noqa: S311  # from the system; no verdict depends on it
        judge = PythonJudge(counter, subject.name, given)
        own = hash_seeds.seeds_of(subject, seeds)
        more = first_lane and given is None and hash_seeds.are_more_tried(subject, own)
        self._plays = BothPlays(Setup(subject, limits, deadline=deadline), own, random)
        self._judges = Judges(judge, random, native=subject.compiled, compiles=first_lane)
        self._settler = Settler(judge, self._plays)
        self._more_seeds = MoreSeeds(self._settler, random, wanted=more)
        self._losses = losses.Losses()
        self._works: list[Work] = []
        self._waiting: deque[RunBatch] = deque()
        self._across: Across | None = None
        self._first_logs: dict[AtPlace, FirstLog] = {}
        self._size, self._reported = LEAST, time.monotonic()
        self._due = self._judged = self._settled = 0

    # ---------------------------------------------------------------- units

    def offer(self, unit: units.UnitOfRuns) -> None:
        """Take a unit, on which the next calls of :meth:`turn` work."""
        work = Work(unit, self.counter.tally())
        if isinstance(unit, units.AcrossUnit):
            work.open, seeds = 1, hash_seeds.across(self._plays.seeds)
            self._across = Across(self._plays.setup, self._judges.python, work, seeds)
        else:
            work.batches = self._judges.of(unit).batches(work, lambda: self._size)
        self._works.append(work)

    @property
    def hungry(self) -> bool:
        """Whether the lane could begin another unit."""
        return len(self._works) < 2 * DEPTH and all(work.batches is None for work in self._works)

    @property
    def busy(self) -> bool:
        """Whether the lane has a unit that is not finished."""
        return bool(self._works)

    @property
    def keeps(self) -> bool:
        """Whether the lane keeps runs that :meth:`end` will play under further hash seeds."""
        return bool(self._more_seeds)

    def turn(self, others: Sequence[int] = ()) -> list[units.PartialResult]:
        """Give work to the players, and hear them once; return the partial results that are due.

        Args:
            others: descriptors, such as that of the link to the owner; once one of them is
                readable, the method stops waiting for the players.

        Raises:
            InputError: if the explorer cannot be loaded, or if a lighthouse, task or condition of
                the user fails.
            Unsettled: if processes are lost again and again, or the explorer is silent too often.
            HarnessError: if a player fails because of an error in this package.
        """
        if self.given_up:
            raise Unsettled(self.given_up)
        self._give()
        players = self._plays.players + (self._across.players if self._across else [])
        if any(player.jobs for player in players):
            wait(players, limits.POLL, others)
            self._hear(FIRST)
            self._hear(SECOND)
        if self._across and len(self._works) == 1:  # the units of the runs are done
            self._hear_across(self._across)
        return self._done()

    def end(self) -> tally.Tally:
        """Play some runs of large worlds once more, after all units; return the tally.

        The lane has kept these runs for this; they are played under further hash seeds.  The tally
        holds the findings and remarks of these plays; the runs are not counted again.
        """
        return self._more_seeds.end()

    def close(self) -> None:
        """End all players."""
        self._plays.close()
        if self._across:
            self._across.close()

    def _done(self) -> list[units.PartialResult]:
        """The results of the finished units; at intervals also the counts of unfinished units."""
        late = bool(self.given_up) or time.monotonic() > self._reported + tally.REPORT_EVERY
        parts = list[units.PartialResult]()
        for work in [*self._works]:
            whole = work.batches is None and not work.more and not work.open
            if whole:
                self._works.remove(work)
                if not self._works and not self._due == self._judged == self._settled:
                    raise RuntimeError("runs were left out")
                for due, cost in work.best.values():
                    self.counter.count_best(due.world, cost, work.tally)
            if whole or late:
                walk = None if whole else self._plays.longest_walk()
                parts.append(units.PartialResult(work.unit, work.tally, whole, walk=walk))
                work.tally = self.counter.tally()
                self._reported = time.monotonic()
        return parts

    # ---------------------------------------------------------------- batches

    def _give(self) -> None:
        """Give each player batches until the player has no room for another batch."""
        while self._plays.has_room(FIRST) and (batch := self._next()):
            self._due += len(batch)
            self._plays.give(FIRST, batch, range(len(batch)))
        while self._waiting and self._plays.has_room(SECOND):
            batch = self._waiting.popleft()
            # A run in which a player was lost is not compared: the second log is the first.
            for index in batch.lost:
                batch.take(SECOND, [index], [batch.logs[FIRST][index]])
            if indices := batch.unplayed(SECOND, range(len(batch))):
                self._plays.give(SECOND, batch, indices)
            else:
                self._settle(batch)

    def _next(self) -> RunBatch | None:
        """The next batch for the first player; None if no batch can be made now.

        A unit gives its own batches first.  If every schedule is tried, further batches are made of
        runs that are played again under their next schedule; such runs come from judged batches.
        """
        for work in self._works:
            batch = next(work.batches, None) if work.batches else None
            if batch is None:
                work.batches = None
            if batch is None and work.more and (len(work.more) >= MOST or not work.open):
                some, work.more = work.more[:MOST], work.more[MOST:]
                batch = RunBatch(self._judges.python, work, some)
            if batch is not None:
                work.open += 1
                return batch
        return None

    def _hear(self, which: int) -> None:
        """Store the logs that have come from a player; judge or settle the batches with all logs.

        If the player is lost, :meth:`_lose` says what follows.
        """
        began = time.monotonic()
        try:
            batches = self._plays.hear(which)
        except Lost as lost:
            self._lose(which, lost)
            return
        for batch in batches:
            self._played(which, batch)
        if batches and which == FIRST:
            slow = self._plays.here and time.monotonic() > began + tally.REPORT_EVERY
            self._size = max(1, self._size // 2) if slow else min(MOST, 2 * self._size)

    def _played(self, which: int, batch: RunBatch) -> None:
        """Take the next step with a batch, if the player ``which`` has now played all its runs.

        After the first play the batch is judged, and then waits for the second player; if there is
        only one player, the batch is settled at once.  If the batch cannot be judged, because
        compiled code could not write all logs of a shared library, the first player plays the batch
        again in Python.  After the second play the batch is settled.
        """
        if len(batch.logs[which]) < len(batch):
            return
        if which == SECOND:
            self._settle(batch)
        elif not batch.by.judge(batch):  # Python plays them
            batch.plain, batch.logs[FIRST] = True, {}
            self._plays.give(FIRST, batch, range(len(batch)))
        else:
            self._judged += len(batch)
            remember(batch, self._first_logs)
            self._judges.remember(batch)
            batch.work.more += batch.follow_ups()
            if self._twice:
                self._waiting.append(batch)
            else:
                self._settle(batch)

    def _settle(self, batch: RunBatch) -> None:
        """Find the runs of a batch that break a law; add the counts of the batch to its unit."""
        self._settler.settle(batch, twice=self._twice)
        self._settled += len(batch)
        batch.work.tally.add(batch.tally)
        batch.work.open -= 1
        self._more_seeds.keep(batch)

    def _lose(self, which: int, lost: Lost) -> None:
        """Go on after the loss of the player ``which``.

        If the player was lost in a run, a fresh player plays this run alone, which shows what the
        loss means.  Then a new process takes the place of the lost player, unless the lane gives
        up.
        """
        if which == FIRST:
            self._first_logs.clear()  # the logs of one process alone are wanted
        batch, index = self._plays.lost_in(which)
        if batch is not None and index is None:
            self._losses.remark(batch.work, lost)
        if batch is None or index is None:
            self._plays.go_on(which)
            return
        alone = partial(self._plays.alone, which, batch, index)
        batch.take(which, [index], [self._losses.log_of(lost, batch, index, alone)])
        timeout = self._plays.setup.limits.answer_timeout
        self.given_up = losses.given_up(self._losses.silences, timeout)
        if self.given_up:
            self._settler.give_up(which, batch)
            return
        self._plays.go_on(which)
        self._played(which, batch)

    # ---------------------------------------------------------------- across units

    def _hear_across(self, across: Across) -> None:
        """Go on with an :class:`AcrossUnit`, whose runs are played in two opposite orders.

        The first call begins these two plays, and later calls read their logs.  Once both plays are
        complete, the logs are compared: a run whose log depends on earlier runs refutes the
        explorer.

        The two plays are given up if a loss was repeated in this lane: a player was lost in a run
        of another unit, and then a fresh player that played the same run alone was lost, too.  Such
        a loss refutes the explorer already; and the explorer would probably end the processes of
        the two plays, too.

        Args:
            across: the two plays of the unit.
        """
        if not (across.begun or self._losses.repeated):
            across.begin(self._first_logs)
        elif self._losses.repeated or across.hear(self._losses.remark):
            across.close()
            across.settle()
            self._settler.find(across.batch, across.found)
            if across.odd:
                _, seed = hash_seeds.across(self._plays.seeds)
                self._settler.explain_under(seed, across.batch, across.odd, FIRST)
            across.work.open, self._across = 0, None
