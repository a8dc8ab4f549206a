"""Origin of a document: all that differs from run to run (version, host, time, speed)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from datetime import UTC, datetime
from time import perf_counter
from typing import TYPE_CHECKING, TypedDict

from allworlds.version import __version__

if TYPE_CHECKING:
    from allworlds.document import MadeBy, UnsetType


class MeasuredEffort(TypedDict, total=False):
    """Measurements that only the verb can report.

    Attributes:
        workers: processes or threads; left out by a verb that takes none.
        level_seconds: of each level, where each is timed.
        claim_seconds: of each claim.
    """

    workers: int
    level_seconds: Sequence[float]
    claim_seconds: Sequence[float]


@dataclass(frozen=True, slots=True)
class _BegunCommand:
    """A command line and the time when it was started."""

    command: tuple[str, ...]
    started: datetime
    clock: float


_COMMAND: ContextVar[_BegunCommand] = ContextVar("command")


@contextmanager
def beginning(command: Sequence[str]) -> Iterator[None]:
    """Context manager that notes the beginning of a command."""
    begun = _BegunCommand(tuple(command), datetime.now(UTC), perf_counter())
    token = _COMMAND.set(begun)
    try:
        yield
    finally:
        _COMMAND.reset(token)


def made_by(effort: MeasuredEffort) -> MadeBy:
    """Origin and measurements of a document that is written now."""
    from allworlds.document import UNSET, MadeBy
    from allworlds.version import host

    def rounded(each: Sequence[float] | None) -> tuple[float, ...] | UnsetType:
        return UNSET if each is None else tuple(round(seconds, 3) for seconds in each)

    begun = _COMMAND.get()
    return MadeBy(
        version=__version__,
        command=begun.command,
        workers=effort.get("workers"),
        host=host(),
        started=begun.started.strftime("%Y-%m-%dT%H:%M:%SZ"),
        seconds=round(perf_counter() - begun.clock, 3),
        level_seconds=rounded(effort.get("level_seconds")),
        claim_seconds=rounded(effort.get("claim_seconds")),
    )
