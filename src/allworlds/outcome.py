"""What every verb hands back: a result with an exit code and a document."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from enum import IntEnum, StrEnum
from typing import Any, Protocol, TypeVar

T = TypeVar("T")


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
    DISAGREES = INTERNAL


class Verdict(StrEnum):
    """What was found out about an explorer."""

    HOLDS = "holds"
    REFUTED = "refuted"
    INCONCLUSIVE = "inconclusive"
    VACUOUS = "vacuous"
    ERROR = "error"
    NOT_REFUTED = "not-refuted"

    @property
    def exit(self) -> Exit:
        """Its exit code."""
        return _EXITS[self]


_EXITS = {
    Verdict.HOLDS: Exit.HOLDS,
    Verdict.NOT_REFUTED: Exit.HOLDS,
    Verdict.REFUTED: Exit.REFUTED,
    Verdict.INCONCLUSIVE: Exit.INCONCLUSIVE,
    Verdict.VACUOUS: Exit.VACUOUS,
    Verdict.ERROR: Exit.INTERNAL,
}


def until_interrupted(rows: Iterable[T]) -> tuple[tuple[T, ...], bool]:
    """The rows that were made before the user interrupted, and whether they are all."""
    made: list[T] = []
    try:
        for row in rows:
            made.append(row)  # noqa: PERF402  # what is made before an interrupt is kept
    except KeyboardInterrupt:
        return tuple(made), False
    return tuple(made), True


class Result(Protocol):
    """What a verb hands back."""

    @property
    def exit_code(self) -> int:
        """One of :class:`Exit`."""

    def to_json(self) -> Mapping[str, Any]:
        """The JSON document."""
