"""The job of an engine."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from allworlds.engines.python.scope import Scope
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject


@dataclass(frozen=True, slots=True)
class Job:
    """A check as an engine gets it.

    Attributes:
        scope, subject: what is checked.
        limits: workers, and time.
        keep: how many findings are kept.
        deadline: on the monotonic clock, or None.
        notice: takes a text that the user may want to read at once.
        dask: where units are done: the address of a scheduler, ``local``, or None for here.
    """

    scope: Scope
    subject: Subject
    limits: Limits
    keep: int
    deadline: float | None
    notice: Callable[[str], None]
    dask: str | None = None
