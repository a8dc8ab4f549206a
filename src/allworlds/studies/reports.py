"""Reports of what was finished when a job ended."""

from typing import Self

from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.documents.report import Report


class EndedReport(Report):
    """A report of what was finished when a job came to its ``ending``."""

    ending: doc.NotInDocument[outcome.Ending]

    @property
    def whole(self) -> bool:
        """Whether it is about all of the job, and not a shard of it."""
        return True

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
        return isinstance(self.ending, outcome.Stopped)

    @property
    def empty(self) -> bool:
        """Whether there was nothing to be answered."""
        return False

    @property
    def interrupted(self) -> bool:
        """Whether the user interrupted the job."""
        return isinstance(self.ending, outcome.Interrupted)

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
    def facts(self) -> outcome.Facts:
        return outcome.Facts(
            disagrees=not self.agrees or isinstance(self.ending, outcome.Disagreed),
            interrupted=self.interrupted,
            refuted=self.refuted,
            undecided=self.undecided,
            vacuous=self.whole and self.empty,
        )


class RowsReport(EndedReport):
    """A report with rows of all that was finished."""

    @doc.computed
    def complete(self) -> doc.AllRows:
        """Whether every row is there."""
        return isinstance(self.ending, outcome.Completed | outcome.Disagreed)
