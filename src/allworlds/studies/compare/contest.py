"""Runs of explorers in the same worlds, level by level."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby
from typing import Any

from msgspec import Struct
from typing_extensions import override

from allworlds.document.struct import replace
from allworlds.engines.job_records import Identity
from allworlds.engines.progress import Listener
from allworlds.engines.scope import GivenWorlds, UnitOfRuns
from allworlds.engines.units import WHOLE, Portion, Shard, SweptLevel, level_size
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import takes_fields
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.outcome import Ending, Stopped
from allworlds.studies.check.report import GateCell, count_gate
from allworlds.studies.compare.climb import GrowingWorlds, growing
from allworlds.studies.compare.compare_request import CompareRequest
from allworlds.studies.compare.comparison import (
    ComparedRow,
    Comparison,
    DifferMost,
    InMap,
    rounded,
    row_of,
)
from allworlds.studies.compare.contestants import (
    Contest,
    Contestant,
    CostsOfAll,
    CostTally,
    InWorld,
    MapKey,
    UnitOfOne,
    contestants_known,
    contestants_of,
)
from allworlds.studies.compare.growing_families import Member, form_of
from allworlds.studies.compare.growth import Growth
from allworlds.world.world import World


def compared(request: CompareRequest) -> Comparison | Growth:
    """Answer a request of ``compare``."""
    return _contest(contestants_of(request), request).answer(request.run)


@takes_fields(CompareRequest, several="explorers", answered=compared)
def compare(*explorers: str | Callable[..., Any], **options: Any) -> Comparison | Growth:
    """Run explorers in the same worlds, judge every run, and compare what they walk.

    With ``to`` the worlds grow: of each family a few members of each size are run; then one
    explorer is enough.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    return compared(CompareRequest(explorers=explorers, **options))


def _contest(
    contestants: tuple[Contestant, ...], request: CompareRequest
) -> SameWorlds | GrowingWorlds:
    """The sweep for a request."""
    if request.to is not None:
        return growing(contestants, request, request.to)
    for name in ("worlds", "places"):
        if (given := getattr(request, name)) is not None:
            raise InputError(
                f"{name} = {show(given)} is for worlds that grow: with --to M worlds of each size "
                "up to M edges are drawn from a family without a size, as in --family corridor"
            )
    if len(contestants) < 2:
        only = show(contestants[0].name) if contestants else "none"
        raise InputError(f"compare takes two explorers at least, not {only}")
    edges, vertices = request.edges, request.vertices
    families, holes = request.family, request.holes
    if families is not None:
        family = ",".join(families)
        if all(map(form_of, families)):
            raise InputError(
                f"family {show(family)} names no world: give a size, as in lattice:3x4, for one "
                "world, or --to M for worlds that grow up to M edges"
            )
        if edges is not None or vertices is not None:
            raise InputError(f"family {show(family)} is one world; it takes no edges or vertices")
        if request.where is not None:
            raise InputError(f"family {show(family)} is one world; where has no effect on it")
        seed = request.seed or 0
        return SameWorlds(contestants, replace(request, seed=seed), Member(family, holes, seed))
    if holes is not None:
        raise InputError(f"holes {holes} has no effect without a family")
    if edges is None and vertices is None:
        raise InputError("compare takes edges, vertices or a family")
    return SameWorlds(contestants, request)


class _Apart(Struct, frozen=True):
    """A rooted map, and each explorer's mean cost there."""

    map: CombinatorialMap
    costs: Mapping[str, Fraction]

    @property
    def by(self) -> Fraction:
        """The largest difference between the first explorer and another one."""
        first, *others = self.costs.values()
        return max(abs(other - first) for other in others)


class SameWorlds(Contest[Comparison]):
    """The sweep of a comparison through every world of a class, or through one of a family.

    Args:
        contestants: who walks.
        request: what is asked for.
        member: the one world; None for every world of a class.
    """

    def __init__(
        self,
        contestants: Sequence[Contestant],
        request: CompareRequest,
        member: Member | None = None,
    ) -> None:
        map_ = member.map() if member else None
        extent = Extent(request.map_class, map_.edge_count) if map_ else request.extent
        super().__init__(contestants, request, extent, every=map_ is None)
        self._map, self._member = map_, member
        self._rows: list[ComparedRow] = []
        self._gate: list[GateCell] = []
        self._most: _Apart | None = None
        self._in_worlds: list[InWorld] = []

    @override
    @classmethod
    def known(
        cls, identity: Identity, portion: Portion, listener: Listener
    ) -> SameWorlds | GrowingWorlds:
        request = cls.asked_then(identity, portion, listener)
        return _contest(contestants_known(request, identity.explorer["explorers"]), request)

    @override
    def levels(self) -> Iterator[SweptLevel]:
        map_, levels = self._map, self.bounds.levels
        for edges in levels[-1:] if map_ else levels:
            if map_:
                size = sum(len(self._placed(one)) for one in self.contestants)
            else:
                size = level_size(self.bounds, edges) * len(self.contestants)
            yield SweptLevel(edges, size, self._units(edges))

    def _units(self, edges: int) -> Iterator[UnitOfOne]:
        for number, one in enumerate(self.contestants):
            for unit in self._units_of(one, edges):
                yield UnitOfOne(number, unit)

    def _units_of(self, one: Contestant, edges: int) -> Iterable[UnitOfRuns]:
        if self._map is None:
            return one.scope(self.bounds, self.portion).units(edges)
        mine = not isinstance(self.portion, Shard) or self.portion.index == 0
        given = self._placed(one)
        return [GivenWorlds(given)] if given and mine else []

    def _placed(self, one: Contestant) -> tuple[tuple[World, int], ...]:
        """The one world, with every place of a contestant's lighthouse."""
        assert self._map is not None
        places = enumerate(one.rules.kind.places(self._map, 0))
        return tuple((World(self._map, lighthouse, 0), place) for place, lighthouse in places)

    @override
    def finish(self, level: SweptLevel, total: CostsOfAll) -> Ending | None:
        if self._map is None and self.portion == WHOLE:
            self._gate += count_gate(self.bounds, level.edges, total.one(0))
        tallies = [total.one(number) for number in range(len(self.contestants))]
        shared = self._compare([in_maps(tally) for tally in tallies])
        if self.request.by in ("world", "run"):
            self._in_worlds += self._runs(tallies, shared)
        self.leave(level, total)
        return Stopped("a law is broken", final=True) if total.findings else None

    @override
    def report(self, ending: Ending) -> Comparison:
        return Comparison(
            **self.contest(ending),
            rows=tuple(self._rows),
            differ_most=self._differ_most(),
            member=self._member,
            all_counted=all(cell.agrees for cell in self._gate),
            in_worlds=tuple(self._in_worlds),
        )

    def _differ_most(self) -> DifferMost | None:
        if self._most is None or not self._most.by:
            return None
        return DifferMost(
            world=self.contestants[0].first_world(self._most.map),
            costs={name: rounded(cost) for name, cost in self._most.costs.items()},
        )

    def _runs(self, tallies: Sequence[CostTally], shared: Sequence[MapKey]) -> Iterator[InWorld]:
        """The runs of each explorer in these worlds."""
        found: list[dict[MapKey, dict[int, int]]] = [{} for _ in tallies]
        for costs, tally in zip(found, tallies, strict=True):
            for (key, place), cost in sorted(tally.costs.items()):
                costs.setdefault(key, {})[place] = cost
        for key in shared:
            map_ = CombinatorialMap(key[2], key[3])
            for one, costs in zip(self.contestants, found, strict=True):
                bound = one.rules.the_bound.of(map_, 0)
                places = costs[key]
                member = self._member.name if self._member else ""
                yield InWorld(map_, member, one.name, places, len(places), bound)

    def _compare(self, costs: Sequence[Mapping[MapKey, InMap]]) -> list[MapKey]:
        """Add the rows of a level, and return the worlds in which every explorer has a place."""
        shared = sorted(set(costs[0]).intersection(*costs[1:]))
        for (edges, vertices), keys in groupby(shared, key=lambda key: key[:2]):
            maps = [
                {n: cost[key] for n, cost in zip(self.names, costs, strict=True)} for key in keys
            ]
            self._rows.append(row_of(edges, vertices, maps))
        for key in shared:
            means = {n: cost[key].mean for n, cost in zip(self.names, costs, strict=True)}
            candidate = _Apart(CombinatorialMap(key[2], key[3]), means)
            if self._most is None or candidate.by > self._most.by:
                self._most = candidate
        return shared


def in_maps(tally: CostTally) -> dict[MapKey, InMap]:
    """The total costs of the runs in each rooted map."""
    found: dict[MapKey, InMap] = {}
    for (key, _), cost in tally.costs.items():
        known = found.get(key, InMap(0, 0, 0))
        found[key] = InMap(known.runs + 1, known.total + cost, max(known.worst, cost))
    return found
