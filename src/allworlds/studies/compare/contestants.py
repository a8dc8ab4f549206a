"""Explorers that are run in the same worlds, each under its own rules."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from allworlds.engines import (
    CostEngine,
    CostTally,
    Limits,
    Listener,
    Scope,
    Transport,
    UnitOfRuns,
    confirmed,
    gather,
    subject_of,
)
from allworlds.explorers import Subject
from allworlds.inputs import InputError, show
from allworlds.judging import Finding, Rules
from allworlds.maps import CombinatorialMap, Extent
from allworlds.studies.compare.compare_request import CompareRequest
from allworlds.world import World


@dataclass(frozen=True, slots=True)
class Contestant:
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
        """The explorer's, or the label."""
        return self.label or self.subject.name

    def scope(self, extent: Extent) -> Scope:
        """The runs that it has in the worlds of an extent."""
        return Scope(extent, self.rules)

    def first_world(self, map_: CombinatorialMap) -> World:
        """A rooted map with its lighthouse at the first place."""
        return World(map_, next(iter(self.rules.kind.places(map_, 0))), 0)

    def costs(
        self,
        extent: Extent,
        units: Iterable[UnitOfRuns],
        transport: Transport[Any],
        listener: Listener,
    ) -> CostTally:
        """What every run in these worlds has cost, and the smallest finding, not yet confirmed."""
        tally = CostTally(keep=1)
        gather(transport, CostEngine(self.scope(extent), tally.keep), units, tally, listener)
        return tally

    def confirmed(self, tally: CostTally, limits: Limits) -> list[Finding]:
        """The findings of a tally, each played again in a fresh process."""
        return [confirmed(found, self.subject, limits, "one") for found in tally.findings]


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
