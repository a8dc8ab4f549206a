"""The meaning of the loss of a player.

A player is lost in a run if its process ends in the run, or if it is silent for too long.  The *law
of the loss* is the law that the explorer may break by this: ``crash`` or ``timeout``.  After a loss
a fresh player plays the run alone.  If the fresh player is lost, too, it *repeats* the loss.

The left column says what has happened, the right column what follows.  The first row that applies
decides:

    ====================================================  ========================================
    the fresh player repeats the loss                     the run breaks the law of the loss
    the machine cannot be the cause of the loss           the run breaks the law of the loss; the
                                                          finding says that the run breaks this law
                                                          only after other runs in one process
    the loss is a time-out, and an earlier time-out in    the same as in the row above
    this lane was not repeated, either
    none of these                                         a remark, a sentence of the report, which
                                                          refutes nothing
    ====================================================  ========================================

The machine cannot be the cause, for example, if the process has exited without a signal.

A crash that was repeated has refuted the explorer.  So each later crash in this lane counts as
repeated, too, and no fresh player is started for it.  The same holds for time-outs.
"""

from collections import Counter
from collections.abc import Callable
from enum import Enum

from allworlds.engines.batch import RunBatch, Work
from allworlds.engines.players import Lost, Unsettled, lost_log
from allworlds.engines.plays import Attempt

MOST_LOSSES = 20
"""The largest number of losses that become remarks; with more remarks there is no verdict."""

SILENT_RUNS, MOST_WAITED = 4, 60.0
"""A number of runs and a number of seconds.

A run is *silent* if the player was lost in it by a time-out.  A lane gives up after at least
:data:`SILENT_RUNS` silent runs, if it has waited in these runs for at least :data:`MOST_WAITED`
seconds in all.
"""

AFTER = " when it was played after others; by itself it was not"


class Meaning(Enum):
    """The meaning of the loss of a player, for the run in which the player was lost."""

    BROKEN = "the run breaks the law"
    BROKEN_AFTER_OTHERS = "it does when it is played after others"
    REMARK = "nothing is refuted"


def meaning(lost: Lost, *, again: bool, before: int) -> Meaning:
    """The meaning of a loss, by the table of this module.

    Args:
        lost: the loss, with its law.
        again: whether a fresh player repeated a loss by the same law, in this run or in an earlier
            one.
        before: the number of earlier losses by the same law that no fresh player repeated.
    """
    if again:
        return Meaning.BROKEN
    if not lost.machine or (lost.law == "timeout" and before):
        return Meaning.BROKEN_AFTER_OTHERS
    return Meaning.REMARK


def given_up(silences: int, timeout: float) -> str:
    """The reason why a lane gives up after ``silences`` silent runs; empty if it goes on.

    ``timeout`` is the number of seconds of silence after which a player is lost.
    """
    if silences < SILENT_RUNS or silences * timeout < MOST_WAITED:
        return ""
    waited = f"the explorer was silent in {silences} runs, for {timeout:g} s each"
    return f"{waited}, and the other runs would take too long"


class Losses:
    """The losses of the players of a lane.

    Attributes:
        silences: the number of runs in which a player was silent.
        repeated: the laws (``timeout``, ``crash``) of the losses that a fresh player has repeated.
    """

    def __init__(self) -> None:
        self.silences = self._remarks = 0
        self.repeated, self._unrepeated = set[str](), Counter[str]()

    def log_of(self, lost: Lost, batch: RunBatch, run: int, alone: Callable[[], Attempt]) -> bytes:
        """The log that a run gets after a player was lost in it; the losses are counted, too.

        If the loss refutes nothing, the result is the whole log that the fresh player has made, and
        a remark is added.  If the fresh player repeats the loss, the result is the log of the fresh
        player up to its loss.  In all other cases the result holds only the loss, because no action
        is known.

        Args:
            lost: the loss.
            batch: the batch of the run.
            run: the index of the run in the batch.
            alone: the function by which a fresh player plays the run alone.

        Raises:
            Unsettled: if there are too many losses that refute nothing.
        """
        self.silences += lost.law == "timeout"
        known = lost.law in self.repeated
        (log,), again = ([lost_log(b"", lost)], lost) if known else alone()
        means = meaning(lost, again=again is not None, before=self._unrepeated[lost.law])
        if again:
            self.repeated.add(again.law)
        else:
            self._unrepeated[lost.law] += 1
        if means is Meaning.REMARK:
            self.remark(batch.work, lost)
            return log
        batch.lost.add(run)
        if means is Meaning.BROKEN_AFTER_OTHERS:
            return lost_log(b"", Lost(lost.law, lost.seen + AFTER, machine=False))
        return log

    def remark(self, work: Work, lost: Lost) -> None:
        """Add a remark on a loss that refutes nothing to the counts of a unit.

        Args:
            work: the unit in which the player was lost, with its counts so far.
            lost: the loss, which no fresh player has repeated.

        Raises:
            Unsettled: if there are too many such losses.
        """
        fresh = "and a fresh one was not: no refutation"
        work.tally.remark(f"a player was lost ({lost.seen}), {fresh}")
        self._remarks += 1
        if self._remarks > MOST_LOSSES:
            last = f"the last by {lost.seen}, and each time a fresh one was not"
            raise Unsettled(f"{self._remarks} players were lost, {last}")
