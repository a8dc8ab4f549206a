"""Explorers side by side in the same worlds: all worlds of a class, or one world of a family."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby
from operator import eq, gt, lt
from statistics import geometric_mean
from typing import Annotated, Any

from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.engines import kept_units, single, units
from allworlds.engines.listeners import Listener
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import takes_fields
from allworlds.judging.findings.finding import labelled
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.studies.check import report, tally_sweep
from allworlds.studies.compare.entrants import (
    CompareRequest,
    Contest,
    ContestReport,
    CostsOfAll,
    Entrant,
    InWorld,
    UnitOfOne,
    ensure_unnamed,
    entrants_of,
)
from allworlds.studies.compare.growth import GrowingWorlds, Growth, Member, form_of
from allworlds.world.world import World


class ComparedRow(doc.Document):
    """Costs in the worlds of one size. The first explorer is compared with each of the others."""

    edges: doc.Edges
    vertices: doc.Vertices
    worlds: Annotated[
        doc.Positive, doc.about("rooted maps in which every explorer's lighthouse has a place")
    ]
    runs: Annotated[doc.Positive, doc.about("the runs of all explorers in these maps")]
    mean: Annotated[
        dict[str, doc.Figure],
        doc.about("for each explorer its mean cost over the places, then over these maps"),
    ]
    worst: Annotated[
        dict[str, doc.Natural], doc.about("for each explorer the largest cost of a run")
    ]
    ratio: Annotated[
        dict[str, doc.Figure | None],
        doc.about(
            "for each explorer: in each map its mean divided by the first explorer's mean, and of "
            "these ratios the geometric mean; null if a mean is 0"
        ),
    ]
    less: Annotated[
        dict[str, doc.Natural],
        doc.about("in how many maps the first explorer's mean is less than this explorer's"),
    ]
    equal: Annotated[dict[str, doc.Natural], doc.about("in how many maps the means are equal")]
    more: Annotated[dict[str, doc.Natural], doc.about("in how many maps the first's is more")]


class DifferMost(doc.Document):
    """The world in which the mean costs of the first explorer and of another one differ most.

    Of several such worlds, the smallest.
    """

    world: Annotated[World, doc.about("the map with the first explorer's lighthouse")]
    costs: Annotated[dict[str, doc.Figure], doc.about("each explorer's mean cost over the places")]


class Comparison(ContestReport):
    """Report of 'compare'.

    The costs of explorers in the same worlds.

    ``member`` is the world, if the explorers were run in one world of a family, else None;
    ``all_counted``: whether no count of worlds differs from that of an independent source;
    ``in_worlds`` holds each explorer's runs in each world, if the user asks for a row for each
    world or run.
    """

    rows: Annotated[
        tuple[ComparedRow, ...], doc.about("one for each (edges, vertices) of the finished levels")
    ]
    differ_most: Annotated[
        DifferMost | None, doc.about("null: nothing was compared, or nothing differs")
    ]
    member: doc.NotInDocument[Member | None]
    all_counted: doc.NotInDocument[bool]
    in_worlds: doc.NotInDocument[tuple[InWorld, ...]] = ()

    @property
    @override
    def agrees(self) -> bool:
        return self.all_counted

    def walks(self) -> Iterator[single.SingleRun]:
        """Yield a run of each explorer in the world where the costs differ most, if there is one.

        Each explorer's lighthouse is at the first of its places.
        """
        if self.differ_most is None:
            return
        for entrant in self.entrants:
            world = entrant.first_world(self.differ_most.world.map)
            world = doc.replace(world, labels=self.differ_most.world.labels)
            yield single.single_run(entrant.subject, world, entrant.rules, (), self.request.limits)


def compared(request: CompareRequest) -> Comparison | Growth:
    """Answer a request of ``compare``."""
    return _contest(entrants_of(request), request).answer(request.run)


@takes_fields(CompareRequest, several="explorers", answered=compared)
def compare(*explorers: str | Callable[..., Any], **options: Any) -> Comparison | Growth:
    """Run explorers in the same worlds, judge every run, and compare their costs.

    The options are those of :class:`CompareRequest`.  The option ``to`` is a largest number of
    edges.  If it is given, the explorers run in worlds that grow: for each family that the option
    ``family`` names, and for several sizes of its worlds, they run in some members of the family.
    At least two explorers must be given; with the option ``to`` one explorer is enough.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    return compared(CompareRequest(explorers=explorers, **options))


def _contest(
    entrants: tuple[Entrant, ...], request: CompareRequest
) -> "SameWorlds | GrowingWorlds":
    """The sweep that answers a request: ``GrowingWorlds`` if ``to`` is given, else ``SameWorlds``.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if request.to is not None:
        return GrowingWorlds(entrants, request, request.to)
    grow = "worlds that do not grow; give --to M and a family without a size, as --family corridor"
    ensure_unnamed(request, ("draws", "places"), grow)
    if len(entrants) < 2:
        only = show(entrants[0].name) if entrants else "none"
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
        names = ("edges", "vertices", "worlds", "graph", "where")
        ensure_unnamed(request, names, f"family {show(family)}, which is one world")
        seed = request.seed or 0
        return SameWorlds(entrants, doc.replace(request, seed=seed), Member(family, holes, seed))
    if holes is not None:
        raise InputError(f"holes {holes} has no effect without a family")
    if edges is None and vertices is None and request.given is None:
        raise InputError("compare takes edges, vertices, worlds or a family")
    return SameWorlds(entrants, request)


class SameWorlds(Contest[Comparison]):
    """The sweep of a comparison through every world of a class, or through one world of a family.

    Args:
        entrants: the explorers.
        request: the request.
        member: the one world of a family; None for every world of a class.
    """

    def __init__(
        self, entrants: Sequence[Entrant], request: CompareRequest, member: Member | None = None
    ) -> None:
        self._map = member.map() if member else None
        extent = Extent(request.map_class, self._map.edge_count) if self._map else request.extent
        super().__init__(entrants, request, extent, every=member is None)
        self._member = member
        self._rows: list[ComparedRow] = []
        self._gate: list[report.GateCell] = []
        self._difference = Fraction(0)
        self._differ_most: DifferMost | None = None
        self._in_worlds: list[InWorld] = []

    @override
    @classmethod
    def known(
        cls, identity: kept_units.Identity, portion: units.Shard, listener: Listener
    ) -> "SameWorlds | GrowingWorlds":
        request = cls.request_of(identity, portion, listener)
        entrants = tuple(
            Entrant(
                tally_sweep.subject_of_record(one), tally_sweep.rules_known(request, one), one["at"]
            )
            for one in identity.explorer["explorers"]
        )
        return _contest(entrants, request)

    @override
    def levels(self) -> Iterator[units.SweptLevel]:
        for edges in self.bounds.levels[-1 if self._map else 0 :]:
            if self._map:
                size = sum(len(self._placed(one, self._map)) for one in self.entrants)
            else:
                size = units.level_size(self.bounds, edges) * len(self.entrants)
            yield units.SweptLevel(edges, size, self._units(edges))

    def _units(self, edges: int) -> Iterator[UnitOfOne]:
        for number, one in enumerate(self.entrants):
            mine: Iterable[units.UnitOfRuns] = ()
            if self._map is None:
                mine = units.units_of_level(self.bounds, edges, self.portion)
            elif self.portion.index == 0:
                given = self._placed(one, self._map)
                mine = [units.GivenWorlds(given)] if given else ()
            for unit in mine:
                yield UnitOfOne(number, unit)

    def _placed(self, one: Entrant, map_: CombinatorialMap) -> tuple[tuple[World, int], ...]:
        """The worlds of a map, one for each place of an explorer's lighthouse.

        With each world comes the number of the place.
        """
        places = enumerate(one.rules.kind.places(map_, 0))
        return tuple((World(map_, lighthouse, 0), place) for place, lighthouse in places)

    @override
    def finish(self, level: units.SweptLevel, total: CostsOfAll) -> outcome.Ending | None:
        if self._map is None and self.portion == units.WHOLE:
            self._gate += report.count_gate(self.bounds, level.edges, total.one(0))
        tallies = [total.one(number) for number in range(len(self.entrants))]
        first, *others = [tally.costs for tally in tallies]
        shared = sorted(set(first).intersection(*others))
        for (edges, vertices), keys in groupby(shared, key=lambda key: key[:2]):
            found = [[tally.costs[key] for tally in tallies] for key in keys]
            self._rows.append(row_of(edges, vertices, self.names, found))
        for key in shared:
            self._compare(CombinatorialMap(key[2], key[3]), [tally.costs[key] for tally in tallies])
        self.leave(level, total)
        broken = any(tally.findings for tally in tallies)
        return outcome.Stopped("a law is broken", final=True) if broken else None

    def _compare(self, map_: CombinatorialMap, found: Sequence[Mapping[int, int]]) -> None:
        """Keep the map if the mean costs differ more than in all earlier maps.

        Keep the runs in the map, too, if the user asks for a row for each world or run.  ``found``
        has an entry for each explorer: its costs in the map, by the number of the lighthouse's
        place.
        """
        first, *others = means = [_mean(costs) for costs in found]
        difference = max(abs(other - first) for other in others)
        if difference > self._difference:
            self._difference = difference
            world = self.entrants[0].first_world(map_)
            like = () if self.bounds.given is None else self.bounds.given.like(world)
            self._differ_most = DifferMost(
                world=labelled(world, like),
                costs=dict(zip(self.names, map(_rounded, means), strict=True)),
            )
        if self.request.by in ("world", "run"):
            member = self._member.name if self._member else ""
            for one, costs in zip(self.entrants, found, strict=True):
                bound = one.rules.the_bound.of(map_, 0)
                places = dict(sorted(costs.items()))
                self._in_worlds.append(InWorld(map_, member, one.name, places, len(places), bound))

    @override
    def report(self, ending: outcome.Ending) -> Comparison:
        return Comparison(
            **self.contest(ending),
            rows=tuple(self._rows),
            differ_most=self._differ_most,
            member=self._member,
            all_counted=all(cell.agrees for cell in self._gate),
            in_worlds=tuple(self._in_worlds),
        )


def row_of(
    edges: int, vertices: int, names: Sequence[str], maps: Sequence[Sequence[Mapping[int, int]]]
) -> ComparedRow:
    """The row of one size.

    Args:
        edges: the number of edges.
        vertices: the number of vertices.
        names: the names of the explorers.
        maps: a list for each rooted map.  This list has, for each explorer, the costs in the map by
            the number of the place of the explorer's lighthouse.
    """
    by_explorer = dict(zip(names, zip(*maps, strict=True), strict=True))
    means = {name: [_mean(costs) for costs in found] for name, found in by_explorer.items()}
    first, *others = names

    def times(holds: Callable[[Fraction, Fraction], bool]) -> dict[str, int]:
        return {name: sum(map(holds, means[first], means[name])) for name in others}

    def ratio(name: str) -> float | None:
        if not all(means[name]) or not all(means[first]):
            return None
        ratios = [float(a / b) for a, b in zip(means[name], means[first], strict=True)]
        return round(geometric_mean(ratios), 6)

    return ComparedRow(
        edges=edges,
        vertices=vertices,
        worlds=len(maps),
        runs=sum(len(costs) for found in maps for costs in found),
        mean={name: _rounded(sum(found) / len(maps)) for name, found in means.items()},
        worst={n: max(max(costs.values()) for costs in found) for n, found in by_explorer.items()},
        ratio={name: ratio(name) for name in names},
        less=times(lt),
        equal=times(eq),
        more=times(gt),
    )


def _mean(costs: Mapping[int, int]) -> Fraction:
    """The mean cost of the runs; ``costs`` has the cost of each run, by the lighthouse's place."""
    return Fraction(sum(costs.values()), len(costs))


def _rounded(value: Fraction | float) -> float:
    """The number rounded to six decimal places, for a report."""
    return round(float(value), 6)
