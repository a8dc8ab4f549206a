"""Explorers that are compared, each under its own rules."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeVar

from msgspec import Struct
from typing_extensions import override

from allworlds.document import replace
from allworlds.engines import (
    WHOLE,
    By,
    Job,
    Portion,
    ReadyEngine,
    Scope,
    Sweep,
    SweptLevel,
    from_kept,
    players_for,
    subject_of,
)
from allworlds.explorers import Subject
from allworlds.inputs import InputError, show
from allworlds.judging import Finding, Rules
from allworlds.maps import CombinatorialMap, Extent
from allworlds.outcome import Completed, Ending
from allworlds.studies.check import (
    Confirmation,
    record_of,
    rules_known,
    rules_record,
    subject_of_record,
)
from allworlds.studies.compare.compare_request import CompareRequest
from allworlds.studies.compare.side_by_side import CostEngine, CostsOfAll, CostTally, SideBySide
from allworlds.world import World

Answer = TypeVar("Answer")


class Contestant(Struct, frozen=True):
    """An explorer with the rules that its runs are judged by.

    Attributes:
        subject: the explorer.
        rules: how it is played and judged.
        label: what it is called where it is there twice under different rules; else empty.
    """

    subject: Subject
    rules: Rules
    label: str = ""

    @property
    def name(self) -> str:
        """The explorer's name, or the label."""
        return self.label or self.subject.name

    def scope(self, extent: Extent, portion: Portion = WHOLE) -> Scope:
        """The scope of its runs in the worlds of an extent, or in a shard of them."""
        return Scope(extent, self.rules, coverage=portion)

    def first_world(self, map_: CombinatorialMap) -> World:
        """A rooted map with its lighthouse at the first place."""
        return World(map_, next(iter(self.rules.kind.places(map_, 0))), 0)


def contestants_of(request: CompareRequest) -> tuple[Contestant, ...]:
    """The explorers, each under its own lighthouse unless the request names one.

    Raises:
        InputError: for one that is none or is there twice, or for an option.
    """
    contestants: list[Contestant] = []
    for explore in request.explorers:
        subject = subject_of(explore, request.limits)
        if any(subject.name == other.name for other in contestants):
            raise InputError(f"explorer {show(subject.name)} is named twice")
        contestants.append(Contestant(subject, request.rules(subject)))
    return tuple(contestants)


def contestants_known(
    request: CompareRequest, told: Iterable[Mapping[str, Any]]
) -> tuple[Contestant, ...]:
    """The contestants of an identity, without loading their code."""
    return tuple(Contestant(subject_of_record(one), rules_known(request, one)) for one in told)


class Contest(Sweep[CostsOfAll, Answer]):
    """The sweep of several contestants through the same worlds.

    Args:
        contestants: who walks.
        request: for the effort, and for all that the identity holds.
        extent: holds every world.
        every: these are all worlds of the extent.
    """

    verb, asked, result = "compare", CompareRequest, CostsOfAll

    def __init__(
        self,
        contestants: Sequence[Contestant],
        request: CompareRequest,
        extent: Extent,
        *,
        every: bool = False,
    ) -> None:
        super().__init__(request, extent if every else None)
        self.contestants, self.bounds = tuple(contestants), extent
        self.names = [one.name for one in contestants]
        self.findings: list[Finding] = []
        self._found: dict[tuple[int, int], CostTally] = {}

    @override
    def explorer(self) -> dict[str, Any]:
        records = [
            {**record_of(one.subject), **rules_record(one.rules)} for one in self.contestants
        ]
        return {"name": ", ".join(self.names), "explorers": records}

    @override
    def ready(self) -> ReadyEngine:
        limits, cluster, notice = self.request.limits, self.request.cluster, self.listener.notice
        scopes = [one.scope(self.bounds) for one in self.contestants]
        jobs = [
            Job(scope, one.subject, limits, 1, self.deadline, notice, cluster)
            for one, scope in zip(self.contestants, scopes, strict=True)
        ]
        engines = [CostEngine(scope, 1) for scope in scopes]
        return ReadyEngine(SideBySide([players_for(job) for job in jobs]), engines)

    @override
    def empty(self) -> CostsOfAll:
        return CostsOfAll()

    @override
    def read(self, kept: Any) -> CostsOfAll:
        return from_kept(kept, CostsOfAll).under([one.rules for one in self.contestants])

    @override
    def costs(self, total: CostsOfAll) -> Iterable[tuple[int, int, int]]:
        return (cost for tally in total.of.values() for cost in tally.costs_by_size)

    @override
    def leave(self, level: SweptLevel, total: CostsOfAll) -> None:
        """Store the findings: the smallest of each contestant, in each group of levels."""
        for number, tally in total.of.items():
            known = self._found.setdefault((self.group(level), number), CostTally(keep=1))
            for found in tally.findings:
                known.find(found)

    @override
    def list_by(self, by: By) -> None:
        self.request = replace(self.request, by=by)

    def contest(self, ending: Ending) -> dict[str, Any]:
        """Return the keywords of the report of any contest."""
        return {
            **self.ended(ending, self.bounds),
            "findings": tuple(self.findings),
            "contestants": self.contestants,
            "by": self.request.by,
        }

    def group(self, level: SweptLevel) -> int:  # noqa: ARG002  # all are one
        """The number of the group to which a level belongs."""
        return 0

    @override
    def conclude(self, ending: Ending) -> Ending:
        """Confirm the findings of all contestants."""
        for (_, number), tally in sorted(self._found.items()):
            one, limits = self.contestants[number], self.request.limits
            scope = one.scope(self.bounds)
            settled = Confirmation(one.subject, limits, scope, self.deadline, self.records)
            self.findings += settled.confirmed(tally.findings)
        return Completed() if ending.final and self.findings else ending
