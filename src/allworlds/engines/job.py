"""The job of an engine."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from allworlds.engines.python.scope import Scope
from allworlds.engines.units.effort import DaskCluster, Limits
from allworlds.explorers import Subject


class Job(Struct, frozen=True):
    """A check as an engine gets it.

    Attributes:
        scope, subject: of the check.
        limits: of workers and of time.
        keep: the number of findings that are kept.
        deadline: on the monotonic clock, or None.
        notice: takes a text that the user reads at once.
        cluster: that is to do the work; None for work on this machine without Dask.
    """

    scope: Scope
    subject: Subject
    limits: Limits
    keep: int
    deadline: float | None
    notice: Callable[[str], None]
    cluster: DaskCluster | None = None
