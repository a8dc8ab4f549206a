"""Sweeps of one explorer whose results are tallies: ``check`` and ``fuzz``."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, TypeVar

from typing_extensions import override

from allworlds.engines import Job, Scope, Sweep, SweptLevel, Tally, from_kept
from allworlds.explorers import Subject
from allworlds.maps import Extent
from allworlds.studies.check.confirmation import Confirmation
from allworlds.studies.check.run_identity import parameters_of, record_of

Answer = TypeVar("Answer")


class TallySweep(Sweep[Tally, Answer]):
    """The sweep of one explorer through many worlds.

    Args:
        request: what was asked for.
        scope: the worlds, the rules and the schedules.
        subject: the explorer.
        keep: how many findings are kept.
        extent: the worlds, where they are all of a class.

    Attributes:
        job: all of that, for an engine.
    """

    def __init__(
        self,
        request: Any,
        scope: Scope,
        subject: Subject,
        keep: int = 1,
        extent: Extent | None = None,
    ) -> None:
        super().__init__(request, extent)
        self.scope = scope
        notice = self.listener.notice
        self.job = Job(scope, subject, request.limits, keep, self.deadline, notice, request.cluster)

    @override
    def parameters(self) -> dict[str, Any]:
        return parameters_of(self.request, self.scope.rules)

    @override
    def explorer(self) -> dict[str, Any]:
        return record_of(self.job.subject)

    @override
    def levels(self) -> Iterable[SweptLevel]:
        return self.scope.levels

    @override
    def empty(self) -> Tally:
        return Tally(self.job.keep)

    @override
    def read(self, kept: Any) -> Tally:
        return from_kept(kept, Tally).under(self.scope.rules)

    @override
    def costs(self, total: Tally) -> Iterable[tuple[int, int, int]]:
        return total.costs_by_size

    @property
    def confirmation(self) -> Confirmation:
        """The confirmation of this sweep's findings."""
        job = self.job
        return Confirmation(job.subject, job.limits, self.scope, self.deadline, self.records)
