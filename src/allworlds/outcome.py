"""How a job ends, with its exit code and verdict, and what every result of a verb has."""

from collections.abc import Callable, Iterable, Mapping
from enum import IntEnum, StrEnum
from typing import Any, ClassVar, NamedTuple, Protocol, TypeAlias, TypeVar

from msgspec import Struct

T = TypeVar("T")


class Disagreement(RuntimeError):
    """Raised if two ways to one answer disagree: a fault of this program."""


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
    """Raised where there is no result; the command says so in a line.

    Attributes:
        exit: the code with which it ends.
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
        missing: witnesses that a complete check must have seen and has not.
        final: the same job again would do no more.
    """

    missing: tuple[str, ...] = ()
    reason = ""
    stopped = None
    final = True


class Stopped(Struct, frozen=True):
    """A job that was stopped before its end.

    Attributes:
        reason: why.
        final: nothing more is to be done all the same.
    """

    reason: str
    final: bool = False

    @property
    def stopped(self) -> str:
        """The reason, in the words of a report with rows."""
        return self.reason


class Interrupted(Struct, frozen=True):
    """A job that the user interrupted."""

    reason = "interrupted"
    stopped = None
    final = False


class Disagreed(Struct, frozen=True):
    """A job whose two ways to one number gave two numbers. No result counts then."""

    reason: str
    stopped = None
    final = True


COMPLETED = Completed()

Ending: TypeAlias = Completed | Stopped | Interrupted | Disagreed
"""How a job came to its end, each with the reason why it is not complete, if it is not."""


class Facts(NamedTuple):
    """Facts of a report, as far as its exit code and its verdict depend on them.

    Attributes:
        disagrees: two roads to one number lead to different ones.
        interrupted: by the user.
        refuted: a law is broken, or something is not as it should be.
        undecided: something was left undone by which the answer could be another one.
        vacuous: there was nothing to be answered.
        fixed: what was recorded does not happen any more.
    """

    disagrees: bool = False
    interrupted: bool = False
    refuted: bool = False
    undecided: bool = False
    vacuous: bool = False
    fixed: bool = False

    @property
    def exit(self) -> Exit:
        """The exit code. No other place computes one."""
        return next((code for fact, code in zip(self, _CODES, strict=True) if fact), Exit.HOLDS)

    @property
    def verdict(self) -> Verdict:
        """The verdict: after an interrupt everything that is not refuted is undecided."""
        if self.disagrees:
            return Verdict.ERROR
        if self.refuted:
            return Verdict.REFUTED
        if self.interrupted or self.undecided:
            return Verdict.INCONCLUSIVE
        return Verdict.VACUOUS if self.vacuous else Verdict.HOLDS

    @property
    def sample_verdict(self) -> Verdict:
        """The verdict of a sample, which never shows that the laws hold."""
        verdict = self.verdict
        return Verdict.NOT_REFUTED if verdict is Verdict.HOLDS else verdict


_CODES = (
    *(Exit.INTERNAL, Exit.INTERRUPTED, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS),
    Exit.FIXED,
)
"""Of the facts, in their order."""


def ended(job: Callable[[], Ending]) -> Ending:
    """Return the ending of a job, which the user may interrupt."""
    try:
        return job()
    except KeyboardInterrupt:
        return Interrupted()


def until_interrupted(rows: Iterable[T]) -> tuple[tuple[T, ...], Ending]:
    """The rows that were made before the user interrupted, and how it ended."""
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
