"""The common part of studies of one explorer in many worlds, and how run directories know it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields
from typing import Any, TypeVar

from typing_extensions import override

from allworlds.engines.engine_table import Job
from allworlds.engines.job_records import from_kept
from allworlds.engines.scope import Scope
from allworlds.engines.sweep import Sweep
from allworlds.engines.tally import Tally
from allworlds.engines.units import SweptLevel
from allworlds.explorers.loading import Subject, subject_known
from allworlds.explorers.sources import content_digest
from allworlds.inputs.requests import as_json, meant
from allworlds.judging.findings.rules import Among, AskedRules, Rules
from allworlds.maps.classes import Extent
from allworlds.studies.check.confirmation import Confirmation


def parameters_of(request: object, rules: Rules) -> dict[str, Any]:
    """The request for the record, with the rules that follow from it and the explorer."""
    return {**meant(request), **rules_record(rules)}


def rules_record(rules: Rules) -> dict[str, Any]:
    """Record of those rules that may come from the explorer."""
    names = ("lighthouse", "step_budget", "promised", "own_bound", "shared_file")
    return {name: as_json(getattr(rules, name)) for name in names}


def rules_known(request: object, told: Mapping[str, Any]) -> Rules:
    """The rules of a request with this record."""
    names = [field.name for field in fields(AskedRules)]
    asked = {name: getattr(request, name) for name in names if hasattr(request, name)}
    asked["step_budget"] = told["step_budget"]
    kept = {name: told[name] for name in ("promised", "own_bound", "shared_file")}
    among = Among.of(getattr(request, "where", None))
    return Rules(told["lighthouse"], among=among, **kept, **asked)


def record_of(subject: Subject) -> dict[str, Any]:
    """Record of an explorer, identified by its content.

    Raises:
        InputError: if it cannot be.
    """
    return {
        "name": subject.name,
        "keywords": sorted(subject.keywords),
        "digest": content_digest(subject),
    }


def subject_of_record(told: Mapping[str, Any]) -> Subject:
    """The explorer of such a record. Its code is not loaded, because its results are known."""
    return subject_known(told["name"], told["keywords"])


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
