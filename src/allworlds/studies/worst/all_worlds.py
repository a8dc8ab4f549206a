"""Every world of a class and every schedule: the worst cost, the world, the choices."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

from allworlds.engines import (
    ENDED,
    UNMERGEABLE,
    WHOLE,
    Dask,
    Identity,
    Limits,
    Listener,
    Portion,
    Records,
    Shard,
    ThisThread,
    Threads,
    Transport,
    Whole,
    cells_of_level,
    gather,
    records_in,
    shards_of,
    shelf,
    units_of_level,
)
from allworlds.explorers import Subject, algorithm1, load
from allworlds.inputs import InputError, an_integer, answers, show
from allworlds.judging import Answered, AskedRules, Rules, default_step_budget, paper_bound, play
from allworlds.maps import CombinatorialMap, Extent, MapClass, source_for
from allworlds.outcome import until_interrupted
from allworlds.studies.worst.any_explorer import worst_of_runs
from allworlds.studies.worst.every_schedule import EverySchedule, Planned, Transit
from allworlds.studies.worst.worst_report import WorstReport, WorstRow, replayed_cost
from allworlds.studies.worst.worst_request import DEFAULT_EDGES, OTHERS_EDGES, WorstRequest
from allworlds.words import size
from allworlds.world import Directional, World

if TYPE_CHECKING:
    from allworlds.engines import ScheduleCosts
    from allworlds.studies.worst.compiled_engine import ScheduleSearch

MOST_EDGES = 12

SYMMETRY = (
    "one world for each start vertex: every choice of dart is tried, so the "
    "dart faced at the start and the bearing make no difference"
)


@answers(WorstRequest)
def worst(request: WorstRequest) -> WorstReport:
    """The exact worst and best cost of an explorer over all worlds and all schedules.

    For Algorithm 1 under its own lighthouse a compiled search covers every choice of edge, order
    of hypotheses and path.  Of any other explorer every run is played, in each place of its
    lighthouse and, if it takes choices, under every schedule; there ``transit``, ``shard``,
    ``run`` and ``dask`` are refused.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if request.explore not in ("algorithm1", algorithm1) or request.lighthouse is not None:
        shard = request.shard
        part = (shard.index, shard.count) if isinstance(shard, Shard) else None
        special = {"transit": request.transit, "shard": part}
        for option, value in {**special, "run": request.run, "dask": request.dask}.items():
            if value is not None:
                raise InputError(f"{option} = {show(value)} is for algorithm1 as it is built in")
        return worst_of_runs(request, Extent(request.map_class, _edges(request, OTHERS_EDGES)))
    way: Transit = request.transit or "simple"
    if an_integer("workers", request.workers) < 1:
        raise InputError(f"workers {show(request.workers)} is not positive")
    extent = Extent(request.map_class, _edges(request, DEFAULT_EDGES))
    if not extent.map_class.plain:
        raise InputError(
            f"class {show(extent.map_class.value)} is none of those whose maps the compiled search "
            f"makes: {', '.join(known for known in MapClass if known.plain)}"
        )
    return _searched(_SchedulesSearch(extent, way, request.shard), request)


def _searched(search: _SchedulesSearch, request: WorstRequest) -> WorstReport:
    """The report of a search with the compiled engine."""
    from allworlds.engines import COMPILING

    run, heard, workers = request.run, request.listener, request.workers
    engine = search.engine()
    transport = Threads(workers) if request.dask is None else Dask(request.dask, workers)
    with records_in(run, search.identity, heard.notice) as records, transport as there:
        if run is None and isinstance(search.portion, Shard):
            heard.notice(UNMERGEABLE)
        if not engine.is_compiled():
            heard.notice(COMPILING)
        return search.report(there, engine, records, heard)


def _edges(request: WorstRequest, default: int) -> int:
    number = default if request.edges is None else an_integer("edges", request.edges)
    if number > MOST_EDGES:
        raise InputError(f"edges = {show(number)}, but there is room for {MOST_EDGES} at most")
    return number


def merged_worst(identity: Identity, records: Records, listener: Listener) -> WorstReport:
    """The report of a search that others have done, made from what they have kept.

    Raises:
        Gap: if something is missing.
    """
    told = identity.parameters
    extent = Extent(MapClass(told["class"]), told["edges"])
    with ThisThread() as here:
        return _SchedulesSearch(extent, told["transit"], WHOLE).report(
            here, None, records, listener
        )


@dataclass(frozen=True, slots=True)
class _SchedulesSearch:
    """What is looked for, and where."""

    extent: Extent
    transit: Transit
    portion: Portion
    subject: Subject = field(default_factory=partial(load, "algorithm1"))

    @property
    def rules(self) -> Rules:
        """What every run is judged by."""
        return AskedRules().rules_of(self.subject, Directional.kind)

    def engine(self) -> ScheduleSearch:
        from allworlds.studies.worst.compiled_engine import ScheduleSearch

        return ScheduleSearch(self.extent, self.transit)

    def identity(self) -> Identity:
        parameters = {
            "class": self.extent.map_class.value,
            "edges": self.extent.edges,
            "transit": self.transit,
        }
        return Identity(
            verb="worst",
            parameters=parameters,
            explorer={"name": "algorithm1"},
            shard=str(self.portion),
        )

    def report(
        self, transport: Transport[Any], engine: Any, records: Records, listener: Listener
    ) -> WorstReport:
        from allworlds.studies.worst.compiled_engine import ScheduleCostsBySize

        extent, whole = self.extent, isinstance(self.portion, Whole)
        kept = shelf(records, ScheduleCostsBySize.from_json)
        missing: list[tuple[int, int]] = []

        def level_rows(level: int) -> list[WorstRow]:
            cells = cells_of_level(extent, level)
            listener.level(level, sum(cells.values()) // shards_of(self.portion))
            most_expensive = ScheduleCostsBySize()
            units = units_of_level(extent, level, self.portion)
            gather(transport, engine, units, most_expensive, listener, kept)
            if whole:
                missing.extend(
                    (level, n) for n, count in cells.items() if count and n not in most_expensive
                )
            return [
                self._row(level, costs, cells.get(n, 0) if whole else None)
                for n, costs in sorted(most_expensive.by_vertices.items())
            ]

        finished, complete = until_interrupted(level_rows(level) for level in extent.levels)
        if complete:
            records.note("ended", ENDED)
        return WorstReport(
            map_class=extent.map_class,
            edges=extent.levels[-1],
            transit=self.transit,
            schedules="all",
            symmetry=SYMMETRY,
            shard=str(self.portion),
            complete=complete,
            rows=tuple(row for level in finished for row in level),
            source=source_for(extent.map_class).name,
            disagreement=f"no map with {size(*missing[0])} was met" if missing else "",
            subject=self.subject,
            rules=self.rules,
        )

    def _row(self, edges: int, costs: ScheduleCosts, counted: int | None) -> WorstRow:
        bound = paper_bound(costs.vertices, edges)
        world = World(CombinatorialMap(costs.sigma, costs.alpha), Directional(0), 0)
        choices, replayed = ((), None) if costs.wrong else self._replayed(world, bound)
        return WorstRow(
            edges=edges,
            vertices=costs.vertices,
            worlds=costs.rooted,
            worst=costs.worst,
            best=costs.best,
            bound=bound,
            tests=costs.tests,
            wrong_tests=costs.wrong,
            world=world,
            choices=choices,
            replayed=replayed,
            counted=counted,
        )

    def _replayed(self, world: World, bound: int) -> tuple[tuple[int, ...], int | None]:
        """Choices that attain the worst cost, and what they cost in the Python engine."""
        schedules = EverySchedule(world.map, world.start, self.transit)
        planned = Planned(schedules.most_expensive_picks())
        episode = play(world, self.subject.player(), planned, default_step_budget(bound))
        if not isinstance(episode.ending, Answered):
            return (), None
        choices = tuple(planned.record)
        return choices, replayed_cost(self.subject, world, self.rules, choices, Limits())
