"""Every world of a class and every schedule: the worst cost, the world, the choices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

from allworlds.engines import (
    ENDED,
    UNMERGEABLE,
    WHOLE,
    Dask,
    Identity,
    Limits,
    Portion,
    Records,
    Shard,
    ThisThread,
    Threads,
    Transport,
    Whole,
    a_shard,
    cells_of_level,
    gather,
    records_in,
    shards_of,
    shelf,
    single_run,
    units_of_level,
)
from allworlds.explorers import algorithm1, load
from allworlds.inputs import InputError, an_integer, show
from allworlds.judging import Answered, default_step_budget, paper_bound, play
from allworlds.maps import CombinatorialMap, Extent, MapClass, source_for
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener, Silent
from allworlds.studies.check import own_rules
from allworlds.studies.worst.any_explorer import RunsReport, worst_of_runs
from allworlds.studies.worst.every_schedule import EverySchedule, Planned, Transit
from allworlds.world import Directional, World

if TYPE_CHECKING:
    from allworlds import documents
    from allworlds.engines import ScheduleCosts
    from allworlds.studies.worst.compiled_engine import ScheduleSearch

DEFAULT_EDGES, OTHERS_EDGES = 5, 3
MOST_EDGES = 12


@dataclass(frozen=True, slots=True)
class WorstRow:
    """What every schedule can cost in the worlds of one size.

    Attributes:
        edges, vertices: the size.
        worlds: rooted maps.
        worst: the largest cost of a schedule.
        best: the largest, over the worlds, of the cost of the cheapest schedule.
        bound: (1) + (2).
        tests: different tests of false hypotheses, on every simple path.
        wrong: how many of them confirmed one.
        counted: rooted maps according to the independent source.
        world: the least world that attains the worst cost.
        choices: a sequence of choices that attains it there.
        replayed: the cost when the Python engine takes these choices.
    """

    edges: int
    vertices: int
    worlds: int
    worst: int
    best: int
    bound: int
    tests: int
    wrong: int
    counted: int
    world: World
    choices: tuple[int, ...] = ()
    replayed: int | None = None

    @property
    def agrees(self) -> bool:
        """The count and the replay say the same as the compiled engine."""
        return self.worlds == self.counted and self.repeats

    @property
    def repeats(self) -> bool:
        """The replay does."""
        return bool(self.wrong) or self.replayed == self.worst

    def to_json(self) -> documents.WorstRowDocument:
        """One row of the document."""
        return {
            "edges": self.edges,
            "vertices": self.vertices,
            "worlds": self.worlds,
            "worst": self.worst,
            "best": self.best,
            "bound": self.bound,
            "tests": self.tests,
            "wrong_tests": self.wrong,
            "world": self.world.to_json(),
            "choices": list(self.choices),
            "replayed": self.replayed,
        }


@dataclass(frozen=True, slots=True)
class WorstReport:
    """The worst and best costs, by size.

    Attributes:
        extent: class and bounds.
        transit: how line 4 is read.
        source: the independent source of the counts.
        rows: ascending by (edges, vertices).
        missing: sizes of which the source knows maps, and none was met.
        complete: False if the user has interrupted, and levels are missing.
        portion: which part of the worlds was looked at.
    """

    extent: Extent
    transit: Transit
    source: str
    rows: tuple[WorstRow, ...]
    missing: tuple[tuple[int, int], ...] = ()
    complete: bool = True
    portion: Portion = WHOLE

    @property
    def agrees(self) -> bool:
        """Counts and replays say the same as the compiled engine; of a shard the replays."""
        if isinstance(self.portion, Shard):
            return all(row.repeats for row in self.rows)
        return not self.missing and all(row.agrees for row in self.rows)

    @property
    def exit_code(self) -> Exit:
        """0 answered, 1 refuted, 4 no world, 70 engines or counts disagree, 130 interrupted."""
        if not self.agrees:
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        if any(row.wrong or row.worst > row.bound for row in self.rows):
            return Exit.REFUTED
        whole = isinstance(self.portion, Whole)
        return Exit.VACUOUS if whole and not self.rows else Exit.ANSWERED

    def to_json(self) -> documents.WorstDocument:
        """The document of ``worst --json``."""
        return {
            "schema": SCHEMA,
            "exit_code": self.exit_code,
            "explorer": "algorithm1",
            "lighthouse": "directional",
            "class": self.extent.map_class.value,
            "edges": self.extent.levels[-1],
            "transit": self.transit,
            "schedules": "all",
            "symmetry": "one world for each start vertex: every choice of dart is tried, so the "
            "dart faced at the start and the bearing make no difference",
            "shard": str(self.portion),
            "gate": {"source": self.source, "agrees": self.agrees},
            "complete": self.complete,
            "rows": [row.to_json() for row in self.rows],
            "findings": [],
        }


def worst(
    explore: str | Callable[..., Any] = "algorithm1",
    *,
    edges: int | None = None,
    map_class: str = "maps",
    transit: str | None = None,
    lighthouse: str | None = None,
    shard: tuple[int, int] | None = None,
    workers: int = 1,
    run: str | Path | None = None,
    dask: str | None = None,
    listener: Listener | None = None,
) -> WorstReport | RunsReport:
    """The exact worst and best cost of an explorer over all worlds and all schedules.

    For Algorithm 1 under its own lighthouse a compiled search covers every choice of edge, order
    of hypotheses and path.  Of any other explorer every run is played, in each place of its
    lighthouse and, if it takes choices, under every schedule.

    Args:
        explore: a name or a generator function.
        edges: the largest number of edges (default: one that takes a second).
        map_class: one of :class:`~allworlds.maps.classes.MapClass`.
        transit: ``shortest`` or ``simple`` (default): how the robot goes through S in line 4; of
            Algorithm 1 only, as are ``shard``, ``run`` and ``dask``.
        lighthouse: that of another explorer; None takes its own.
        shard: ``(K, N)``: only the K-th of N parts of about equal weight, from 0.
        workers: threads.
        run: a directory that keeps what is finished; the same search goes on from there.
        dask: the address of a Dask scheduler, or ``local``: where the work is done.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if explore not in ("algorithm1", algorithm1) or lighthouse is not None:
        part = None if a_shard(shard) == WHOLE else shard
        special = {"transit": transit, "shard": part, "run": run, "dask": dask}
        for option, value in special.items():
            if value is not None:
                raise InputError(f"{option} = {show(value)} is for algorithm1 as it is built in")
        extent = Extent(MapClass.named(map_class), _edges(edges, OTHERS_EDGES))
        return worst_of_runs(explore, extent, lighthouse, workers, listener or Silent())
    transit = "simple" if transit is None else transit
    if transit not in get_args(Transit):
        raise InputError(f"transit {show(transit)} is not one of {', '.join(get_args(Transit))}")
    if an_integer("workers", workers) < 1:
        raise InputError(f"workers {show(workers)} is not positive")
    extent = Extent(MapClass.named(map_class), _edges(edges, DEFAULT_EDGES))
    if not extent.map_class.plain:
        raise InputError(
            f"class {show(extent.map_class.value)} is none of those whose maps the compiled search "
            f"makes: {', '.join(known for known in MapClass if known.plain)}"
        )
    from allworlds.engines import COMPILING

    way: Transit = "shortest" if transit == "shortest" else "simple"
    search = _SchedulesSearch(extent, way, a_shard(shard))
    heard = listener or Silent()
    engine = search.engine()
    transport = Threads(workers) if dask is None else Dask(dask, workers)
    with records_in(run, search.identity, heard.notice) as records, transport as there:
        if run is None and isinstance(search.portion, Shard):
            heard.notice(UNMERGEABLE)
        if not engine.is_compiled():
            heard.notice(COMPILING)
        return search.report(there, engine, records, heard)


def _edges(edges: int | None, default: int) -> int:
    number = default if edges is None else an_integer("edges", edges)
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

        extent = self.extent
        kept = shelf(records, ScheduleCostsBySize.from_json)
        missing: list[tuple[int, int]] = []

        def level_rows(level: int) -> list[WorstRow]:
            cells = cells_of_level(extent, level)
            listener.level(level, sum(cells.values()) // shards_of(self.portion))
            most_expensive = ScheduleCostsBySize()
            units = units_of_level(extent, level, self.portion)
            gather(transport, engine, units, most_expensive, listener, kept)
            found = sorted(most_expensive.by_vertices.items())
            missing.extend(
                (level, n) for n, count in cells.items() if count and n not in most_expensive
            )
            rows = [_row(level, row, cells.get(n, 0)) for n, row in found]
            return [_replayed(row, self.transit) for row in rows]

        finished, complete = until_interrupted(level_rows(level) for level in extent.levels)
        if complete:
            records.note("ended", ENDED)
        rows = tuple(row for level in finished for row in level)
        source = source_for(extent.map_class).name
        return WorstReport(
            extent, self.transit, source, rows, tuple(missing), complete, self.portion
        )


def _row(edges: int, most_expensive: ScheduleCosts, counted: int) -> WorstRow:
    return WorstRow(
        edges,
        most_expensive.vertices,
        most_expensive.rooted,
        most_expensive.worst,
        most_expensive.best,
        paper_bound(most_expensive.vertices, edges),
        most_expensive.tests,
        most_expensive.wrong,
        counted,
        World(CombinatorialMap(most_expensive.sigma, most_expensive.alpha), Directional(0), 0),
    )


def _replayed(row: WorstRow, transit: Transit) -> WorstRow:
    """The row with choices that attain the worst cost, and what they cost in the Python engine."""
    if row.wrong:
        return row
    schedules = EverySchedule(row.world.map, row.world.start, transit)
    planned = Planned(schedules.most_expensive_picks())
    budget = default_step_budget(row.bound)
    algorithm1 = load("algorithm1")
    episode = play(row.world, algorithm1.player(), planned, budget)
    if not isinstance(episode.ending, Answered):
        return row
    choices = tuple(planned.record)
    rules = own_rules(algorithm1, {}, row.world.lighthouse.kind)
    again = single_run(algorithm1, row.world, rules, choices, Limits())
    holds = again.finding is None
    return replace(row, choices=choices, replayed=again.outcome.cost if holds else None)
