"""The base of the reports of jobs that ended, completely or not."""

from typing import Self

from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.documents.report import Report


class EndedReport(Report):
    """A report of the finished part of a job; ``ending`` says how the job ended."""

    ending: doc.NotInDocument[outcome.Ending]

    @property
    def whole(self) -> bool:
        """Whether the report is about the whole job, not about a shard."""
        return True

    @property
    def agrees(self) -> bool:
        """Whether the counts agree with those of an independent source; true without a source."""
        return True

    @property
    def refuted(self) -> bool:
        """Whether a law is broken or, in a ledger, a claim is not as expected; false by default."""
        return False

    @property
    def undecided(self) -> bool:
        """Whether work was left out that could change the verdict; interruptions do not count.

        By default the value is true if ``ending`` is ``Stopped``: the job ended early, for example
        at the time limit, at the loss of a cluster, or after enough findings.  If the user
        interrupted the job, the property :attr:`interrupted` is true, and this one is false.
        """
        return isinstance(self.ending, outcome.Stopped)

    @property
    def empty(self) -> bool:
        """Whether the job tried no world or no case, so that the verdict is vacuous."""
        return False

    @property
    def interrupted(self) -> bool:
        """Whether the user interrupted the job."""
        return isinstance(self.ending, outcome.Interrupted)

    def uninterrupted(self) -> Self:
        """Return this report, unless the user interrupted the job.

        This method is for callers that cannot use the report of an interrupted job.

        Raises:
            KeyboardInterrupt: if the user interrupted the job.
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
    """A report with a table, whose rows are about the finished part of the job."""

    @doc.computed
    def complete(self) -> doc.AllRows:
        """Whether no row is missing."""
        return isinstance(self.ending, outcome.Completed | outcome.Disagreed)
