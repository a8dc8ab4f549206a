"""The search for runs of a batch that break a law, after both plays of every run.

If the two plays of some runs differ, both plays of these runs are repeated, each under its own hash
seed.  Each of the two is repeated twice: once in the order of these runs, and once in the reverse
order.  A fresh player makes each of these four repetitions.  The table of
:mod:`allworlds.engines.hash_seeds` says what follows.  Either the hash seeds explain the
difference; then each run is judged under both of these seeds.  Or the explorer is nondeterministic.
But if the machine may have ended one of the first two plays of a run, further plays of this run
decide whether the explorer is nondeterministic.

The parameter ``index`` of a method is the index of a run in its batch; ``seeds`` are the hash seeds
of the two plays.
"""

from collections.abc import Sequence
from typing import TypeAlias

from allworlds.documents.document import replace
from allworlds.engines import hash_seeds
from allworlds.engines.batch import FIRST, SECOND, Due, Recorded, RunBatch
from allworlds.engines.hash_seeds import Seeds
from allworlds.engines.judge import PythonJudge
from allworlds.engines.players import Logs
from allworlds.engines.plays import BothPlays
from allworlds.judging.differences import difference_of, nondeterministic, overruled
from allworlds.judging.episode import fault_of
from allworlds.judging.referee import Outcome
from allworlds.log import Log

MOST_SETTLED = 16
"""The largest number of runs of a batch that are played anew because their plays differ."""

OTHER_CHOICES = (
    "the choices of one schedule are not those of the next, as far as they are asked for"
)

PLAYED_ONCE_MORE = "when it was played once more, the walk or the answer was another"

Differing: TypeAlias = Sequence[tuple[int, Log]]
"""The indices of runs whose two plays differ, each with the log of the second play."""


class Settler:
    """Finder of runs that break a law, in batches that have been played.

    Args:
        judge: the judge of the runs.
        plays: the two players of the lane, and fresh players.
    """

    def __init__(self, judge: PythonJudge, plays: BothPlays) -> None:
        self.judge, self.plays = judge, plays

    def differ(self, one: Log, other: Log) -> bool:
        """Whether two plays of one run, given by their logs, differ."""
        return difference_of(one, other, choices=self.judge.every) is not None

    def settle(self, batch: RunBatch, *, twice: bool) -> None:
        """Find the runs of a batch that break a law, and put their findings into the unit's tally.

        ``twice`` tells whether a second player has also played the runs.
        """
        # Compiled code writes logs without texts and choices; the log of a lost player has them.
        without_words = [] if batch.plain else [*batch.broken]
        outcomes = {i: self._in_words(batch, i) for i in without_words if i not in batch.lost}
        outcomes = {index: self._own(batch, index) for index in batch.broken} | outcomes
        if twice and (differing := self._differing(batch)):
            outcomes |= self._explained(batch, differing, self.plays.seeds, SECOND)
        self.find(batch, outcomes)

    def find(self, batch: RunBatch, outcomes: dict[int, Outcome]) -> None:
        """Put a finding into the unit's tally for each run whose outcome breaks a law.

        Args:
            batch: the batch.
            outcomes: some outcomes, by the indices of their runs in the batch.
        """
        counter, referee = self.judge.counter, self.judge.referee
        for index, outcome in sorted(outcomes.items()):
            due = batch.due(index)
            counter.settle(referee, due.world, due.place, outcome, batch.work.tally)

    def give_up(self, which: int, batch: RunBatch) -> None:
        """Judge only those runs of a batch in which a player was lost, since the lane gives up.

        For each of these runs that breaks a law, a finding is put into the unit's tally, so that
        the report can show it.  The counts of the batch are not added to the tally, because the
        batch is not finished.

        If the second player was lost last, the two logs of each of these runs are compared, too.
        If the first player was lost last, there is only one log of each run.

        Args:
            which: the player that was lost last, FIRST or SECOND.
            batch: the batch.
        """
        outcomes = dict[int, Outcome]()
        for index in batch.lost:
            one = self.judge.judged(batch.due(index), batch.logs[FIRST][index])
            second = Log(batch.logs[which][index])
            outcomes[index] = overruled(one.outcome, one.log, second, choices=self.judge.every)
        self.find(batch, outcomes)

    def explain_under(self, seed: int, batch: RunBatch, differing: Differing, which: int) -> None:
        """Find out why runs have other logs under a second hash seed; keep the findings.

        Further plays show whether the hash seeds explain the difference of the logs.  If they do, a
        run gives a finding only if the run breaks a law under at least one of the two seeds.  If
        they do not, the difference in general gives a finding that the explorer is
        nondeterministic.  But if the machine may have ended one of the two plays of a run, two
        later plays decide instead, provided that they agree.

        Args:
            seed: the hash seed of the second logs; the first logs have the first player's seed.
            batch: the batch of the runs, with their first logs.
            differing: the indices of these runs, each with its second log.
            which: FIRST if the second logs were made in worlds, SECOND if they were made by the
                percepts of the first logs.
        """
        seeds = self.plays.seeds[FIRST], seed
        self.find(batch, self._explained(batch, differing, seeds, which))

    def _differing(self, batch: RunBatch) -> Differing:
        """The indices of the runs whose two logs differ, each with the second log."""
        found = list[tuple[int, Log]]()
        first, again = batch.logs
        if isinstance(first, Logs) and isinstance(again, Logs) and first.message == again.message:
            return found
        for index in range(len(batch)):
            if first[index] != again[index]:
                second = Log(again[index])
                if self.differ(batch.outcome(index).log, second):
                    found.append((index, second))
        return found

    def _own(self, batch: RunBatch, index: int) -> Outcome:
        """The outcome of a run by its first play.

        If every schedule is tried, the message to the player prescribes the first choices of the
        run, which are its script.  If the play did not make these choices, the outcome says that
        the explorer is nondeterministic.
        """
        one = batch.outcome(index)
        if not one.fits:
            return replace(one.outcome, violation=nondeterministic(OTHER_CHOICES))
        return one.outcome

    def _in_words(self, batch: RunBatch, index: int) -> Outcome:
        """The outcome of a run that compiled code has played; Python plays the run once more.

        The log of compiled code holds no texts; the log of the new play holds those that a finding
        shows.  If the walk or the answer of the new play is another, the outcome says that the
        explorer is nondeterministic.
        """
        before, batch.plain = batch.outcome(index), True
        (log,), _ = self.plays.alone(FIRST, batch, index)
        one = self.judge.judged(batch.due(index), log)
        if _is_refused(before.log, one.log) or not self.differ(before.log, one.log):
            return one.outcome
        return replace(one.outcome, violation=nondeterministic(PLAYED_ONCE_MORE))

    def _explained(
        self, batch: RunBatch, differing: Differing, seeds: Seeds, which: int
    ) -> dict[int, Outcome]:
        """The outcomes, by index, of runs whose two plays differ, after further plays of them.

        Args:
            batch: the batch of the runs.
            differing: the indices of the runs, each with the log of the second play.
            seeds: the hash seeds of the two plays.
            which: the player whose way of playing the second play had, see :meth:`explain_under`.
        """
        few, plays = dict(differing[:MOST_SETTLED]), self.plays
        orders = [*few], [*few][::-1]
        firsts = [plays.again(FIRST, seeds[FIRST], batch, order) for order in orders]
        seconds = [plays.again(which, seeds[SECOND], batch, order) for order in orders]
        before = {index: batch.outcome(index).log for index in few}
        repeated = [(before[index], [play[index] for play in firsts]) for index in few]
        repeated += [(other, [play[index] for play in seconds]) for index, other in few.items()]
        if hash_seeds.explain(seeds, repeated, self.differ):
            return self._by_seed(batch, [index for index, _ in differing], seeds)
        return {index: self._of_plays(batch, index, other, seeds) for index, other in few.items()}

    def _of_plays(self, batch: RunBatch, index: int, other: Log, seeds: Seeds) -> Outcome:
        """The outcome of a run whose two plays differ; ``other`` is the log of the second play.

        The hash seeds do not explain the difference of the plays.  So the difference refutes the
        explorer, with one exception.  If the machine may have ended one of the two plays, fresh
        players play the run twice more; if these later plays agree, the outcome follows from them.
        """
        one, anew = batch.outcome(index), None
        faults = fault_of(one.log), fault_of(other)
        if any(fault and fault.machine for fault in faults):  # it may be the machine's
            anew = self._alike(batch, index, other, seeds)
        return anew or overruled(one.outcome, one.log, other, choices=self.judge.every)

    def _alike(self, batch: RunBatch, index: int, other: Log, seeds: Seeds) -> Outcome | None:
        """The outcome of a run by two later plays; None if the logs of these two plays differ.

        Two plays of the run were made before, and they differ.  The machine may have ended one of
        them; so this play refutes nothing if the later plays agree.  Then its end becomes a remark.
        ``other`` is the log of the second play that was made before.

        In each later play a fresh player plays this run alone.  The first later play is in the
        world.  The second later play is by the percepts of the first later play.  The percepts of
        the plays that were made before are not used: they may end too early.
        """
        due, one = batch.due(index), batch.outcome(index).log
        log = self.plays.again(FIRST, seeds[FIRST], batch, [index])[index]
        anew = self._anew(due, log)
        message = self.judge.percepts_message([Recorded.of(due, anew.episode)])
        again = self.plays.fresh(seeds[SECOND], lambda _: message, [index])
        if self.differ(log, again[index]):
            return None
        fault = fault_of(one if self.differ(one, log) else other)
        ended = fault.seen if fault else "it ended with an answer"
        batch.work.tally.remark(f"a run ended otherwise when it was tried again; at first: {ended}")
        return anew

    def _anew(self, due: Due, log: Log) -> Outcome:
        episode = self.judge.episode(due.world, log)
        return self.judge.referee.outcome(due.world, episode, tuple(log.choices))

    def _by_seed(self, batch: RunBatch, indices: list[int], seeds: Seeds) -> dict[int, Outcome]:
        """The outcomes that break a law, by index, of runs whose plays depend on the hash seed.

        A run that breaks no law under either seed is right, and is left out of the result.  The
        logs under the first seed exist already; under the second seed the runs are played once
        more, in their worlds.  ``indices`` holds the indices of the runs.
        """
        batch.work.tally.remark(hash_seeds.GOES_BY_HASHES)
        again = self.plays.again(FIRST, seeds[SECOND], batch, indices)
        outcomes = {
            i: hash_seeds.by_seed(seeds, self._own(batch, i), self._anew(batch.due(i), log))
            for i, log in again.items()
        }
        return {index: outcome for index, outcome in outcomes.items() if outcome}


def _is_refused(without_words: Log, in_words: Log) -> bool:
    """Whether both plays of a run end with an illegal action, after the same legal actions.

    ``without_words`` is a log of compiled code, which says only that an illegal action followed the
    legal ones.  ``in_words`` is the log of a play in Python, whose last action is the illegal one.
    """
    known = without_words.actions
    faults = fault_of(without_words), fault_of(in_words)
    illegal = all(fault and fault.law == "illegal-action" for fault in faults)
    return illegal and in_words.actions[: len(known)] == known == in_words.actions[:-1]
