"""Reports of jobs that may end early: what was finished, and how the job ended."""

from __future__ import annotations

from typing import Self

from typing_extensions import override

from allworlds.document import AllRows, Aside, Report, computed
from allworlds.engines.units.shards import WHOLE, Portion
from allworlds.outcome import Completed, Disagreed, Ending, Facts, Interrupted, Stopped


class EndedReport(Report):
    """A report of what was finished when a job came to its ``ending``."""

    ending: Aside[Ending]

    @property
    def portion(self) -> Portion:
        """The part of the job that was to be done."""
        return WHOLE

    @property
    def whole(self) -> bool:
        """Whether it is about all of the job, and not a shard of it."""
        return self.portion == WHOLE

    @property
    def agrees(self) -> bool:
        """Whether the numbers agree with what they were compared with."""
        return True

    @property
    def refuted(self) -> bool:
        """Whether a law is broken, or something is not as it should be."""
        return False

    @property
    def undecided(self) -> bool:
        """Whether something was left undone by which the answer could be another one."""
        return isinstance(self.ending, Stopped)

    @property
    def empty(self) -> bool:
        """Whether there was nothing to be answered."""
        return False

    @property
    def interrupted(self) -> bool:
        """Whether the user interrupted the job."""
        return isinstance(self.ending, Interrupted)

    def uninterrupted(self) -> Self:
        """Return this report, for callers that can do nothing with a part of it.

        Raises:
            KeyboardInterrupt: if it was interrupted; who made it has kept that to itself.
        """
        if self.interrupted:
            raise KeyboardInterrupt
        return self

    @property
    @override
    def facts(self) -> Facts:
        return Facts(
            disagrees=not self.agrees or isinstance(self.ending, Disagreed),
            interrupted=self.interrupted,
            refuted=self.refuted,
            undecided=self.undecided,
            vacuous=self.whole and self.empty,
        )


class RowsReport(EndedReport):
    """A report with rows of all that was finished."""

    complete: AllRows = computed(lambda report: isinstance(report.ending, Completed | Disagreed))
