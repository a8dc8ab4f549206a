"""Explorers are run in the same worlds, level by level."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from fractions import Fraction
from inspect import signature
from itertools import groupby
from typing import Any, TypedDict, Unpack, overload

from allworlds.engines import (
    CostTally,
    GivenWorlds,
    Limits,
    Listener,
    MapKey,
    Transport,
    UnitOfRuns,
    level_size,
    workers_for,
)
from allworlds.inputs import InputError, ensure_takes, show
from allworlds.judging import Finding
from allworlds.maps import CombinatorialMap, Extent, MapClass
from allworlds.studies.check import (
    Completed,
    GateCell,
    Stopped,
    count_gate,
    ending_of,
)
from allworlds.studies.compare.climb import SEED, WORLDS, growth_of
from allworlds.studies.compare.compare_request import CompareRequest
from allworlds.studies.compare.comparison import (
    ComparedRow,
    Comparison,
    DifferMost,
    InMap,
    rounded,
    row_of,
)
from allworlds.studies.compare.contestants import Contestant, contestants_of
from allworlds.studies.compare.growing_families import FORMS, form_of
from allworlds.studies.compare.growth import Growth
from allworlds.world import World, map_of_family


class SameWorldsOptions(TypedDict, total=False):
    """The fields of :class:`CompareRequest`, in worlds that do not grow.

    They stand here once more: a list of explorers of any length cannot be said otherwise.
    """

    edges: int | None
    vertices: int | None
    map_class: str
    family: str | Sequence[str] | None
    holes: str | None
    seed: int | None
    lighthouse: str | None
    policy: str
    bound: str | int | None
    laws: Iterable[str] | None
    step_budget: int | None
    answer_timeout: float
    workers: int
    time_limit: float | None
    memory: int | None
    listener: Listener | None


class CompareOptions(SameWorldsOptions, total=False):
    """All of them."""

    to: int | None
    worlds: int | None


@overload
def compare(
    *explorers: str | Callable[..., Any],
    to: int,
    worlds: int | None = ...,
    **options: Unpack[SameWorldsOptions],
) -> Growth: ...
@overload
def compare(
    *explorers: str | Callable[..., Any], **options: Unpack[SameWorldsOptions]
) -> Comparison: ...
@overload
def compare(
    *explorers: str | Callable[..., Any], **options: Unpack[CompareOptions]
) -> Comparison | Growth: ...
def compare(
    *explorers: str | Callable[..., Any], **options: Unpack[CompareOptions]
) -> Comparison | Growth:
    """Run explorers in the same worlds, judge every run, and compare what they walk.

    With ``to`` the worlds grow: of each family a few members of each size are run, and how the
    cost grows is fitted; then one explorer is enough.

    Args:
        explorers: names (see :func:`allworlds.explorers.loading.load`) or generator functions; two
            or more.
        options: the worlds, and how runs are judged; see :class:`CompareRequest`.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    ensure_takes("compare", signature(CompareRequest), **options)
    return compared(CompareRequest(explorers=explorers, **options))


def compared(request: CompareRequest) -> Comparison | Growth:
    """The same of a request."""
    limits = request.limits
    contestants = contestants_of(request)
    if request.to is not None:
        return _growing(contestants, request, request.to)
    if request.worlds is not None:
        raise InputError(f"worlds = {show(request.worlds)} has no effect without to")
    if len(contestants) < 2:
        only = show(contestants[0].name) if contestants else "none"
        raise InputError(f"compare takes two explorers at least, not {only}")
    return _contest(contestants, request, limits).run()


def _growing(contestants: tuple[Contestant, ...], request: CompareRequest, to: int) -> Growth:
    """Explorers in families that grow."""
    for name in ("edges", "vertices", "holes"):
        if (given := getattr(request, name)) is not None:
            raise InputError(f"{name} = {show(given)} has no effect on worlds that grow")
    if request.map_class is not MapClass.MAPS:
        raise InputError(f"class {show(request.map_class.value)} has no effect on worlds that grow")
    if not contestants:
        raise InputError("compare with to takes an explorer at least, not none")
    families = request.family
    if not families:
        raise InputError(f"compare with to takes a family at least: {FORMS}")
    numbers = {
        "to": to,
        "worlds": WORLDS if request.worlds is None else request.worlds,
        "seed": SEED if request.seed is None else request.seed,
    }
    named = families.split(",") if isinstance(families, str) else [*families]
    return growth_of(contestants, named, numbers, request.limits, request.listener)


def _contest(
    contestants: tuple[Contestant, ...], request: CompareRequest, limits: Limits
) -> _Contest:
    """Explorers in every world of a class, or in one of a family."""
    edges, vertices = request.edges, request.vertices
    family, holes, heard = request.family, request.holes, request.listener
    if family is not None:
        if not isinstance(family, str) or all(form_of(each) for each in family.split(",")):
            raise InputError(
                f"family {show(family)} names no world: give a size, as in lattice:3x4, for one "
                "world, or to (--to M) for worlds that grow up to M edges"
            )
        if edges is not None or vertices is not None:
            raise InputError(f"family {show(family)} is one world; it takes no edges or vertices")
        seed = request.seed or 0
        map_ = map_of_family(family, holes, seed)
        extent = Extent(request.map_class, map_.edge_count)
        text = f"{family}{f' with holes {holes}' if holes else ''}, seed {seed}"
        return _Contest(contestants, extent, limits, heard, text, map_)
    if holes is not None:
        raise InputError(f"holes {holes} has no effect without a family")
    if edges is None and vertices is None:
        raise InputError("compare takes edges, vertices or a family")
    return _Contest(contestants, request.extent, limits, heard)


@dataclass(frozen=True, slots=True)
class _Apart:
    """A rooted map, and for each explorer its mean there."""

    map: CombinatorialMap
    costs: Mapping[str, Fraction]

    @property
    def by(self) -> Fraction:
        """The largest difference between the first explorer and another."""
        first, *others = self.costs.values()
        return max(abs(other - first) for other in others)


@dataclass(slots=True)
class _Contest:
    """A comparison on its way."""

    contestants: tuple[Contestant, ...]
    extent: Extent
    limits: Limits
    listener: Listener
    family: str = ""
    map: CombinatorialMap | None = None
    rows: list[ComparedRow] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    gate: list[GateCell] = field(default_factory=list)
    most: _Apart | None = None

    def run(self) -> Comparison:
        ending = ending_of(self._levels, self.limits)
        return Comparison(
            complete=isinstance(ending, Completed),
            family=self.family or None,
            map_class=self.extent.map_class,
            edges=None if self.family else self.extent.edges,
            vertices=None if self.family else self.extent.vertices,
            rows=tuple(self.rows),
            differ_most=self._differ_most(),
            stopped=ending.reason if isinstance(ending, Stopped) else None,
            findings=tuple(self.findings),
            all_counted=all(cell.agrees for cell in self.gate),
            contestants=self.contestants,
            limits=self.limits,
        )

    def _differ_most(self) -> DifferMost | None:
        if self.most is None or not self.most.by:
            return None
        return DifferMost(
            world=self.contestants[0].first_world(self.most.map),
            costs={name: rounded(cost) for name, cost in self.most.costs.items()},
        )

    def _levels(self) -> None:
        deadline = self.limits.deadline()
        with ExitStack() as stack:
            transports = [
                stack.enter_context(workers_for(one.subject, self.limits, deadline))
                for one in self.contestants
            ]
            levels = [self.extent.levels[-1]] if self.map else self.extent.levels
            for level in levels:
                if self.findings:
                    return
                self._level(level, transports)

    def _level(self, level: int, transports: Sequence[Transport[Any]]) -> None:
        size = 1 if self.map else level_size(self.extent, level)
        self.listener.level(level, size * len(self.contestants))
        costs = []
        for contestant, transport in zip(self.contestants, transports, strict=True):
            units = self._units(contestant, level)
            tally = contestant.costs(self.extent, units, transport, self.listener)
            costs.append(in_maps(tally))
            if self.map is None and not any(cell.edges == level for cell in self.gate):
                self.gate += count_gate(self.extent, level, tally)
            self.findings += contestant.confirmed(tally, self.limits)
        self._compare(costs)

    def _units(self, contestant: Contestant, level: int) -> Iterable[UnitOfRuns]:
        if self.map is None:
            return contestant.scope(self.extent).units(level)
        places = enumerate(contestant.rules.kind.places(self.map, 0))
        given = tuple((World(self.map, lighthouse, 0), place) for place, lighthouse in places)
        return [GivenWorlds(given)] if given else []

    def _compare(self, costs: Sequence[Mapping[MapKey, InMap]]) -> None:
        names = [contestant.name for contestant in self.contestants]
        shared = sorted(set(costs[0]).intersection(*costs[1:]))
        for (edges, vertices), keys in groupby(shared, key=lambda key: key[:2]):
            maps = [{n: cost[key] for n, cost in zip(names, costs, strict=True)} for key in keys]
            self.rows.append(row_of(edges, vertices, maps))
        for key in shared:
            means = {n: cost[key].mean for n, cost in zip(names, costs, strict=True)}
            candidate = _Apart(CombinatorialMap(key[2], key[3]), means)
            if self.most is None or candidate.by > self.most.by:
                self.most = candidate


def in_maps(tally: CostTally) -> dict[MapKey, InMap]:
    """What the runs of each rooted map cost together."""
    found: dict[MapKey, InMap] = {}
    for (key, _), cost in tally.costs.items():
        known = found.get(key, InMap(0, 0, 0))
        worst = max(known.worst, cost.most_expensive)
        found[key] = InMap(known.runs + 1, known.total + cost.most_expensive, worst)
    return found
