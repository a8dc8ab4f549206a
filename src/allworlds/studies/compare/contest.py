"""Explorers are run in the same worlds, level by level."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import groupby
from typing import Any, Unpack, overload

from allworlds.engines import (
    CostTally,
    GivenWorlds,
    Limits,
    Listener,
    MapKey,
    Silent,
    Transport,
    UnitOfRuns,
    level_size,
    workers_for,
)
from allworlds.inputs import InputError, show
from allworlds.judging import Finding
from allworlds.maps import CombinatorialMap, Extent
from allworlds.studies.check import (
    Completed,
    GateCell,
    ManyRunsOptions,
    Stopped,
    count_gate,
    ending_of,
    refuse_others,
    rules_for,
)
from allworlds.studies.compare.climb import SEED, WORLDS, growth_of
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


class SameWorldsOptions(ManyRunsOptions, total=False):
    """What ``compare`` takes beside the options of many runs, in worlds that are given.

    Attributes:
        edges, vertices: the extent of the class.
        family: one world of a family, in place of a class; with ``to`` one or more families that
            grow, as a list or with commas.
        holes: the share of its edges to be removed.
        seed: for whatever is drawn of it; None (default) for 0, with ``to`` for 1.
    """

    edges: int | None
    vertices: int | None
    family: str | Sequence[str] | None
    holes: str | None
    seed: int | None


class CompareOptions(SameWorldsOptions, total=False):
    """What ``compare`` takes in worlds that grow, too.

    Attributes:
        to: the largest number of edges of worlds that grow; None (default) for the same worlds.
        worlds: how many worlds of each size; None (default) for 3.
    """

    to: int | None
    worlds: int | None


@overload
def compare(
    *explorers: str | Callable[..., Any],
    to: int,
    family: str | Sequence[str],
    worlds: int | None = ...,
    seed: int | None = ...,
    listener: Listener | None = ...,
    **options: Unpack[ManyRunsOptions],
) -> Growth: ...
@overload
def compare(
    *explorers: str | Callable[..., Any],
    listener: Listener | None = ...,
    **options: Unpack[SameWorldsOptions],
) -> Comparison: ...
@overload
def compare(
    *explorers: str | Callable[..., Any],
    listener: Listener | None = ...,
    **options: Unpack[CompareOptions],
) -> Comparison | Growth: ...
def compare(
    *explorers: str | Callable[..., Any],
    listener: Listener | None = None,
    **options: Unpack[CompareOptions],
) -> Comparison | Growth:
    """Run explorers in the same worlds, judge every run, and compare what they walk.

    With ``to`` the worlds grow: of each family a few members of each size are run, and how the
    cost grows is fitted; then one explorer is enough.

    Args:
        explorers: names (see :func:`allworlds.explorers.loading.load`) or generator functions; two
            or more.
        listener: is told of the progress.
        options: the worlds, and how runs are judged; see :class:`CompareOptions`.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    refuse_others("compare", options, CompareOptions)
    limits = Limits.of(options)
    contestants = contestants_of(explorers, limits, options)
    heard = listener or Silent()
    if options.get("to") is not None:
        return _growing(contestants, options, limits, heard)
    if options.get("worlds") is not None:
        raise InputError(f"worlds = {show(options['worlds'])} has no effect without to")
    if len(contestants) < 2:
        only = show(contestants[0].name) if contestants else "none"
        raise InputError(f"compare takes two explorers at least, not {only}")
    return _contest(contestants, options, limits, heard).run()


def _growing(
    contestants: tuple[Contestant, ...], asked: CompareOptions, limits: Limits, heard: Listener
) -> Growth:
    """Explorers in families that grow."""
    for name in ("edges", "vertices", "holes"):
        if asked.get(name) is not None:
            raise InputError(f"{name} = {show(asked.get(name))} has no effect on worlds that grow")
    if asked.get("map_class", "maps") != "maps":
        raise InputError(f"class {show(asked['map_class'])} has no effect on worlds that grow")
    if not contestants:
        raise InputError("compare with to takes an explorer at least, not none")
    families = asked.get("family")
    if not families:
        raise InputError(f"compare with to takes a family at least: {FORMS}")
    seed, worlds = asked.get("seed"), asked.get("worlds")
    numbers = {
        "to": asked["to"] or 0,
        "worlds": WORLDS if worlds is None else worlds,
        "seed": SEED if seed is None else seed,
    }
    named = families.split(",") if isinstance(families, str) else [*families]
    return growth_of(contestants, named, numbers, limits, heard)


def _contest(
    contestants: tuple[Contestant, ...], asked: CompareOptions, limits: Limits, heard: Listener
) -> _Contest:
    """Explorers in every world of a class, or in one of a family."""
    map_class, _ = rules_for(contestants[0].subject, asked)
    edges, vertices = asked.get("edges"), asked.get("vertices")
    family, holes = asked.get("family"), asked.get("holes")
    if family is not None:
        if not isinstance(family, str) or all(form_of(each) for each in family.split(",")):
            raise InputError(
                f"family {show(family)} names no world: give a size, as in lattice:3x4, for one "
                "world, or to (--to M) for worlds that grow up to M edges"
            )
        if edges is not None or vertices is not None:
            raise InputError(f"family {show(family)} is one world; it takes no edges or vertices")
        seed = asked.get("seed") or 0
        map_ = map_of_family(family, holes, seed)
        extent = Extent(map_class, map_.edge_count)
        text = f"{family}{f' with holes {holes}' if holes else ''}, seed {seed}"
        return _Contest(contestants, extent, limits, heard, text, map_)
    if holes is not None:
        raise InputError(f"holes {holes} has no effect without a family")
    if edges is None and vertices is None:
        raise InputError("compare takes edges, vertices or a family")
    return _Contest(contestants, Extent(map_class, edges, vertices), limits, heard)


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
