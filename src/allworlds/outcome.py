"""The ways in which a job ends, exit codes and verdicts, and the interface of a verb's result."""

from collections.abc import Callable, Iterable, Mapping
from enum import IntEnum, StrEnum
from typing import Any, ClassVar, NamedTuple, Protocol, TypeAlias, TypeVar

from msgspec import Struct

T = TypeVar("T")


class Disagreement(RuntimeError):
    """Raised if two computations of one value differ, which is a fault of this program."""


class Exit(IntEnum):
    """The exit codes of the command."""

    HOLDS = 0
    REFUTED = 1
    USAGE = 2
    INCONCLUSIVE = 3
    VACUOUS = 4
    FIXED = 5
    INTERNAL = 70
    INCOMPLETE = 75
    INTERRUPTED = 130

    ANSWERED = HOLDS


class NoResult(Exception):
    """Raised if a command has no result; the command then prints one line about it.

    Attributes:
        exit: the exit code of the command.
    """

    exit: ClassVar[Exit] = Exit.INCONCLUSIVE


class Verdict(StrEnum):
    """The verdict on an explorer."""

    HOLDS = "holds"
    REFUTED = "refuted"
    INCONCLUSIVE = "inconclusive"
    VACUOUS = "vacuous"
    ERROR = "error"
    NOT_REFUTED = "not-refuted"


class Completed(Struct, frozen=True):
    """A job that was done to its end.

    Attributes:
        missing: the witnesses that a complete check must have seen, but this job has not.
        reason: always empty.
        stopped: always None.
        final: always true: if the same job began again with the same run directory, the job would
            find all its work done.
    """

    missing: tuple[str, ...] = ()
    reason = ""
    stopped = None
    final = True


class Stopped(Struct, frozen=True):
    """A job that was stopped before its end.

    Attributes:
        reason: the reason for the stop.
        final: True if nothing is left to do, as after enough findings: if the same job began again
            with the same run directory, the job would do nothing more.  False if the job would go
            on, for example after a time limit.
    """

    reason: str
    final: bool = False

    @property
    def stopped(self) -> str:
        """The reason for the stop, as reports show it under the key ``stopped``."""
        return self.reason


class Interrupted(Struct, frozen=True):
    """A job that the user interrupted."""

    reason = "interrupted"
    stopped = None
    final = False


class Disagreed(Struct, frozen=True):
    """A job in which two computations of one number differed.  Its results do not count."""

    reason: str
    stopped = None
    final = True


COMPLETED = Completed()

Ending: TypeAlias = Completed | Stopped | Interrupted | Disagreed
"""The ways in which a job can end; each has the reason why the job is not complete, if any."""


class Facts(NamedTuple):
    """The facts of a report on which its exit code and its verdict depend.

    Attributes:
        disagrees: whether two computations of one number differ.
        interrupted: whether the user has interrupted the job.
        refuted: whether a law is broken, or another claim is found to be false.
        undecided: whether some work was left out that could change the answer.
        vacuous: whether there was nothing to check.
        fixed: whether a recorded finding does not happen any more.
    """

    disagrees: bool = False
    interrupted: bool = False
    refuted: bool = False
    undecided: bool = False
    vacuous: bool = False
    fixed: bool = False

    @property
    def exit(self) -> Exit:
        """The exit code of the first fact that is true, in the order of :data:`_CODES`; else 0.

        No other part of the program computes exit codes of reports.
        """
        return next((code for fact, code in zip(self, _CODES, strict=True) if fact), Exit.HOLDS)

    @property
    def verdict(self) -> Verdict:
        """The verdict; an interrupted job that has refuted nothing is ``inconclusive``."""
        if self.disagrees:
            return Verdict.ERROR
        if self.refuted:
            return Verdict.REFUTED
        if self.interrupted or self.undecided:
            return Verdict.INCONCLUSIVE
        return Verdict.VACUOUS if self.vacuous else Verdict.HOLDS

    @property
    def sample_verdict(self) -> Verdict:
        """The verdict if only a sample of the worlds was checked.

        The verdict is ``not-refuted`` in place of ``holds``; otherwise it is :attr:`verdict`.
        """
        verdict = self.verdict
        return Verdict.NOT_REFUTED if verdict is Verdict.HOLDS else verdict


_CODES = (
    *(Exit.INTERNAL, Exit.INTERRUPTED, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS),
    Exit.FIXED,
)
"""The exit codes of the facts, in the order of the fields of :class:`Facts`."""


def ended(job: Callable[[], Ending]) -> Ending:
    """Do a job, and return its ending: :class:`Interrupted` if the user interrupts the job."""
    try:
        return job()
    except KeyboardInterrupt:
        return Interrupted()


def until_interrupted(rows: Iterable[T]) -> tuple[tuple[T, ...], Ending]:
    """All rows, and the ending; if the user interrupts, only the rows that were made before."""
    made: list[T] = []
    try:
        for row in rows:
            made.append(row)  # noqa: PERF402  # what is made before an interrupt is kept
    except KeyboardInterrupt:
        return tuple(made), Interrupted()
    return tuple(made), COMPLETED


class Result(Protocol):
    """The result of a verb, which has an exit code and a document."""

    @property
    def exit_code(self) -> int:
        """The exit code, one of :class:`Exit`."""

    def to_json(self) -> Mapping[str, Any]:
        """The JSON document of the result."""
