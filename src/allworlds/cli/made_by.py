"""Origin of a document: all that differs from run to run (version, host, time, speed)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from datetime import UTC, datetime
from time import perf_counter
from typing import TYPE_CHECKING, Any

from allworlds.version import __version__

if TYPE_CHECKING:
    from allworlds.cli.defaults import Defaults
    from allworlds.document.report import MadeBy, Report


@dataclass(frozen=True, slots=True)
class _BegunCommand:
    """A command line and the time when it was started."""

    command: tuple[str, ...]
    defaults: Defaults
    started: datetime
    clock: float


_COMMAND: ContextVar[_BegunCommand] = ContextVar("command")


@contextmanager
def beginning(command: Sequence[str], defaults: Defaults) -> Iterator[None]:
    """Context manager that notes the beginning of a command."""
    begun = _BegunCommand(tuple(command), defaults, datetime.now(UTC), perf_counter())
    token = _COMMAND.set(begun)
    try:
        yield
    finally:
        _COMMAND.reset(token)


def words_of_command() -> tuple[str, ...]:
    """The words of the command that has begun, without the program's name; none without one."""
    begun = _COMMAND.get(None)
    return begun.command if begun else ()


def defaults_used() -> dict[str, dict[str, Any]]:
    """The options that a file gave to the command, by the file; empty if it gave none."""
    begun = _COMMAND.get(None)
    used = begun.defaults if begun else None
    return {used.file: used.used} if used and used.used else {}


def made_by(report: Report, workers: int | None = None) -> MadeBy:
    """Origin and measurements of the document of a report that is written now.

    Args:
        report: may know how long its parts took.
        workers: processes or threads; None of a verb that takes none.
    """
    from allworlds.document.report import MadeBy
    from allworlds.version import host

    parts: dict[str, Any] = {
        name: tuple(round(each, 3) for each in seconds)
        for name, seconds in report.seconds_by_part.items()
    }
    if used := defaults_used():
        parts["defaults"] = used
    begun = _COMMAND.get()
    return MadeBy(
        version=__version__,
        command=begun.command,
        workers=workers,
        host=host(),
        started=begun.started.strftime("%Y-%m-%dT%H:%M:%SZ"),
        seconds=round(perf_counter() - begun.clock, 3),
        **parts,
    )
