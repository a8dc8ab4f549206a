"""Explorers that are run in the same worlds, their shares of a job, and their costs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field as entry
from itertools import groupby
from typing import Any, NamedTuple, Self, TypeAlias, TypeVar

from msgspec import Struct, field
from typing_extensions import override

from allworlds.document.struct import replace
from allworlds.engines.engine_table import Job, ReadyEngine, players_for
from allworlds.engines.examiner import Outcome
from allworlds.engines.job_records import from_kept
from allworlds.engines.scope import GivenWorlds, Scope, UnitOfRuns
from allworlds.engines.single import subject_of
from allworlds.engines.sweep import Sweep
from allworlds.engines.swept_report import By
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import WHOLE, PartialResult, Portion, SweptLevel, Transport
from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import InputError, show
from allworlds.judging.findings.finding import Finding
from allworlds.judging.findings.rules import Rules
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.outcome import Completed, Ending
from allworlds.studies.check.confirmation import Confirmation
from allworlds.studies.check.tally_sweep import (
    record_of,
    rules_known,
    rules_record,
    subject_of_record,
)
from allworlds.studies.compare.compare_request import CompareRequest
from allworlds.world.world import World

MapKey: TypeAlias = tuple[int, int, tuple[int, ...], tuple[int, ...]]
"""Numbers of edges and vertices, sigma and alpha: sorts rooted maps from small to large."""


@dataclass(slots=True)
class CostTally(Tally):
    """A tally that knows every run.

    Attributes:
        costs: by the rooted map, and the number of the lighthouse's place in it.
    """

    costs: dict[tuple[MapKey, int], int] = entry(default_factory=dict)

    def add(self, other: Tally) -> None:
        """Take in another part's tally; no run is in two of them."""
        # Zero-argument super() does not know a class with slots.
        Tally.add(self, other)
        if isinstance(other, CostTally):
            self.costs.update(other.costs)


class CostEngine(RunCounter, frozen=True):
    """The counter that returns the cost of every run, too."""

    def tally(self) -> CostTally:
        """An empty tally."""
        return CostTally(self.keep)

    def count_outcome(self, world: World, place: int, outcome: Outcome, tally: Tally) -> None:
        """Add a run, which has one episode, to the tally, and its cost."""
        super().count_outcome(world, place, outcome, tally)
        assert isinstance(tally, CostTally)
        tally.costs[key_of(world.map), place] = outcome.cost


def key_of(map_: CombinatorialMap) -> MapKey:
    """The key of a map that is rooted at its dart 0."""
    return map_.edge_count, map_.vertex_count, tuple(map_.sigma), tuple(map_.alpha)


class InWorld(NamedTuple):
    """An explorer's runs in one world.

    Attributes:
        map: rooted at dart 0.
        member: the words that name the world in a family; empty where there is no family.
        explorer: its name.
        costs: traversals by the number of the lighthouse's place.
        places: the number of all places.
        bound: on the traversals of a run, the same in each place; None without one.
        drawn_from: the number of different worlds of this size that seeds draw, where it is known.
        finished: all worlds of this size were run.
    """

    map: CombinatorialMap
    member: str
    explorer: str
    costs: Mapping[int, int]
    places: int
    bound: int | None
    drawn_from: int | None = None
    finished: bool = True

    @property
    def mean(self) -> float:
        """The mean cost of the runs."""
        return sum(self.costs.values()) / len(self.costs)


class UnitOfOne(Struct, frozen=True):
    """A unit of runs that one contestant plays."""

    number: int
    unit: UnitOfRuns

    @property
    def key(self) -> str:
        """Key of the unit in a run directory: ``NUMBER/KEY``."""
        return f"{self.number}/{self.unit.key}"

    @property
    def runs(self) -> int:
        """The number of its runs, if they are those of given worlds."""
        return len(self.unit.worlds) if isinstance(self.unit, GivenWorlds) else 0


class CostsOfAll(Struct):
    """Costs of the runs of each contestant, which add up in any order.

    Attributes:
        of: by the number of the contestant.
    """

    of: dict[int, CostTally] = field(default_factory=dict)

    @property
    def worlds(self) -> int:
        """The number of rooted maps, counted once for each contestant."""
        return sum(tally.worlds for tally in self.of.values())

    @property
    def findings(self) -> list[Any]:
        """The smallest finding of each contestant."""
        return [found for tally in self.of.values() for found in tally.findings]

    def one(self, number: int) -> CostTally:
        """The costs of a single contestant."""
        return self.of.setdefault(number, CostTally(keep=1))

    def add(self, other: CostsOfAll) -> None:
        """Add the costs of another part."""
        for number, tally in other.of.items():
            self.one(number).add(tally)

    def under(self, rules: Sequence[Rules]) -> Self:
        """Return the costs under the rules of each contestant."""
        for number, tally in self.of.items():
            tally.under(rules[number])
        return self


class SideBySide:
    """The transports of all contestants as one; each contestant uses its own.

    Args:
        transports: by the number of the contestant; contexts as long as this one is.
    """

    def __init__(self, transports: Sequence[Transport[Any]]) -> None:
        self._transports, self._stack = transports, ExitStack()

    def __enter__(self) -> Self:
        with ExitStack() as stack:
            for transport in self._transports:
                stack.enter_context(transport)
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *error: object) -> None:
        raised: Any = error
        self._stack.__exit__(*raised)

    def map(
        self, engine: Sequence[CostEngine], units: Iterable[UnitOfOne]
    ) -> Iterator[PartialResult[UnitOfOne, CostsOfAll]]:
        """Yield the parts of all units as they come. The units of a contestant stand together."""
        for number, own in groupby(units, key=lambda unit: unit.number):
            transport = self._transports[number]
            for part in transport.map(engine[number], (each.unit for each in own)):
                result = CostsOfAll({number: part.result})
                yield PartialResult(UnitOfOne(number, part.unit), result, part.last)


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
