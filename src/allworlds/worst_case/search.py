"""Every world of a class and every schedule: the worst cost, the world, the choices."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, get_args

from allworlds.checker import run
from allworlds.episode import Answered, default_step_budget, play
from allworlds.inputs import InputError, an_integer, show
from allworlds.judge import paper_bound
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.counting import source_for
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener, Silent
from allworlds.subjects import load
from allworlds.work import Threads, cells_of_level, gather, units_of_level
from allworlds.world import Directional, World
from allworlds.worst_case.one_world import EverySchedule, Planned, Transit

if TYPE_CHECKING:
    from allworlds import documents
    from allworlds.kernel import Dearest

DEFAULT_EDGES = 5
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
        return self.worlds == self.counted and (bool(self.wrong) or self.replayed == self.worst)

    def to_json(self) -> documents.WorstRow:
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
    """

    extent: Extent
    transit: Transit
    source: str
    rows: tuple[WorstRow, ...]
    missing: tuple[tuple[int, int], ...] = ()
    complete: bool = True

    @property
    def agrees(self) -> bool:
        """Counts and replays say the same as the compiled engine."""
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
        return Exit.ANSWERED if self.rows else Exit.VACUOUS

    def to_json(self) -> documents.WorstReport:
        """The document of ``worst --json``."""
        return {
            "schema": SCHEMA,
            "exit_code": self.exit_code,
            "explorer": "algorithm1",
            "class": self.extent.map_class.value,
            "edges": self.extent.levels[-1],
            "transit": self.transit,
            "schedules": "all",
            "symmetry": "one world for each start vertex: every choice of dart is tried, so the "
            "dart faced at the start and the bearing make no difference",
            "gate": {"source": self.source, "agrees": self.agrees},
            "complete": self.complete,
            "rows": [row.to_json() for row in self.rows],
        }


def worst(
    *,
    edges: int | None = None,
    map_class: str = "maps",
    transit: str = "simple",
    workers: int = 1,
    listener: Listener | None = None,
) -> WorstReport:
    """The exact worst and best cost of Algorithm 1 over all worlds and all schedules.

    Args:
        edges: the largest number of edges (default: one that takes a second).
        map_class: one of :class:`~allworlds.maps.classes.MapClass`.
        transit: ``shortest`` or ``simple``: how the robot goes through S in line 4.
        workers: threads.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if transit not in get_args(Transit):
        raise InputError(f"transit {show(transit)} is none of {', '.join(get_args(Transit))}")
    if an_integer("workers", workers) < 1:
        raise InputError(f"workers {show(workers)} is not positive")
    edges = DEFAULT_EDGES if edges is None else an_integer("edges", edges)
    if edges > MOST_EDGES:
        raise InputError(f"edges = {show(edges)}, but there is room for {MOST_EDGES} at most")
    from allworlds.kernel import COMPILING
    from allworlds.worst_case.dearest import DearestWorlds, ScheduleSearch

    extent = Extent(MapClass.named(map_class), edges)
    way: Transit = "shortest" if transit == "shortest" else "simple"
    heard = listener or Silent()
    engine = ScheduleSearch(extent, way)
    if not engine.is_compiled():
        heard.notice(COMPILING)
    missing: list[tuple[int, int]] = []

    def level_rows(threads: Threads, level: int) -> list[WorstRow]:
        cells = cells_of_level(extent, level)
        heard.level(level, sum(cells.values()))
        dearest = DearestWorlds()
        gather(threads, engine, units_of_level(extent, level), dearest, heard)
        found = sorted(dearest.by_vertices.items())
        rows = [_replayed(_row(level, row, cells.get(n, 0)), way) for n, row in found]
        missing.extend((level, n) for n, count in cells.items() if count and n not in dearest)
        return rows

    def levels() -> Iterator[list[WorstRow]]:
        with Threads(workers) as threads:
            for level in extent.levels:
                yield level_rows(threads, level)

    finished, complete = until_interrupted(levels())
    rows = tuple(row for level in finished for row in level)
    return WorstReport(extent, way, source_for(map_class).name, rows, tuple(missing), complete)


def _row(edges: int, dearest: Dearest, counted: int) -> WorstRow:
    return WorstRow(
        edges,
        dearest.vertices,
        dearest.rooted,
        dearest.worst,
        dearest.best,
        paper_bound(dearest.vertices, edges),
        dearest.tests,
        dearest.wrong,
        counted,
        World(CombinatorialMap(dearest.sigma, dearest.alpha), Directional(0), 0),
    )


def _replayed(row: WorstRow, transit: Transit) -> WorstRow:
    """The row with choices that attain the worst cost, and what they cost in the Python engine."""
    if row.wrong:
        return row
    schedules = EverySchedule(row.world.map, row.world.start, transit)
    planned = Planned(schedules.dearest_picks())
    budget = default_step_budget(row.bound)
    episode = play(row.world, load("algorithm1").player(), planned, budget)
    if not isinstance(episode.ending, Answered):
        return row
    choices = tuple(planned.record)
    again = run("algorithm1", row.world, choices=choices)
    holds = again.finding is None
    return replace(row, choices=choices, replayed=again.outcome.cost if holds else None)
