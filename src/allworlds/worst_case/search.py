"""Every world of a class and every schedule: the worst cost, the world, the choices."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass, replace
from itertools import islice
from typing import TYPE_CHECKING, Any, get_args

from allworlds.checker import run
from allworlds.checker.drive import Listener, Silent
from allworlds.episode import Answered, default_step_budget, play
from allworlds.errors import InputError, an_integer
from allworlds.judge import paper_bound
from allworlds.maps.classes import Bounds, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.counting import source_for
from allworlds.maps.enumeration import prefixes, rooted_maps
from allworlds.subjects import load
from allworlds.world import Directional, World
from allworlds.worst_case.one_world import EverySchedule, Planned, Transit

if TYPE_CHECKING:
    from allworlds.kernel.schedules import Dearest

SCHEMA = 1
DEFAULT_EDGES = 5
MOST_EDGES = 12
POLL = 0.1


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

    def to_json(self) -> dict[str, Any]:
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
        bounds: class and bounds.
        transit: how line 4 is read.
        source: the independent source of the counts.
        rows: ascending by (edges, vertices).
        missing: sizes of which the source knows maps, and none was met.
    """

    bounds: Bounds
    transit: Transit
    source: str
    rows: tuple[WorstRow, ...]
    missing: tuple[tuple[int, int], ...] = ()

    @property
    def agrees(self) -> bool:
        """Counts and replays say the same as the compiled engine."""
        return not self.missing and all(row.agrees for row in self.rows)

    @property
    def exit_code(self) -> int:
        """0 answered, 1 Algorithm 1 is refuted, 4 no world, 70 engines or counts disagree."""
        if not self.agrees:
            return 70
        if any(row.wrong or row.worst > row.bound for row in self.rows):
            return 1
        return 0 if self.rows else 4

    def to_json(self) -> dict[str, Any]:
        """The document of ``worst --json``."""
        return {
            "schema": SCHEMA,
            "exit_code": self.exit_code,
            "explorer": "algorithm1",
            "class": self.bounds.map_class.value,
            "edges": self.bounds.edges,
            "transit": self.transit,
            "schedules": "all",
            "symmetry": "one world for each start vertex: every choice of dart is tried, so the "
            "dart faced at the start and the bearing make no difference",
            "gate": {"source": self.source, "agrees": self.agrees},
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
        map_class: ``maps``, ``simple``, ``planar`` or ``planar-simple``.
        transit: ``shortest`` or ``simple``: how the robot goes through S in line 4.
        workers: threads.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if map_class not in list(MapClass):
        raise InputError(f"class {map_class!r} is none of {', '.join(MapClass)}")
    if transit not in get_args(Transit):
        raise InputError(f"transit {transit!r} is none of {', '.join(get_args(Transit))}")
    if an_integer("workers", workers) < 1:
        raise InputError(f"workers {workers} is not positive")
    edges = DEFAULT_EDGES if edges is None else an_integer("edges", edges)
    if edges > MOST_EDGES:
        raise InputError(f"edges = {edges}, but there is room for {MOST_EDGES} at most")
    bounds = Bounds(MapClass(map_class), edges)
    way: Transit = "shortest" if transit == "shortest" else "simple"
    listener = listener or Silent()
    source = source_for(map_class)
    rows: list[WorstRow] = []
    missing: list[tuple[int, int]] = []
    for level in bounds.levels:
        cells = source.cells(level)
        listener.level(level, sum(cells.values()))
        merged = _merged(_parts(bounds, level, way, workers, listener))
        for n, dearest in sorted(merged.items()):
            rows.append(_replayed(_row(level, dearest, cells.get(n, 0)), way))
        missing += [(level, n) for n, count in cells.items() if count and n not in merged]
    return WorstReport(bounds, way, source.name, tuple(rows), tuple(missing))


def _parts(
    bounds: Bounds, edges: int, transit: Transit, workers: int, listener: Listener
) -> Iterator[list[Dearest]]:
    """The outcomes of the parts of a level, as they come."""
    from allworlds.kernel.engine import COMPILING, flag, is_compiled
    from allworlds.kernel.schedules import dearest_of_maps, dearest_of_unit, search, take

    compiled = search if bounds.map_class is MapClass.MAPS else take
    if edges == 1 and not is_compiled(compiled):
        listener.notice(COMPILING)
    if bounds.map_class is not MapClass.MAPS:
        maps = rooted_maps(edges, bounds.map_class)
        yield dearest_of_maps(edges, map(_degrees_and_partners, maps), transit)
        return
    halt = flag()
    units = prefixes(edges, depth=1 if edges < 4 else 3)
    at_work: set[Future[list[Dearest]]] = set()
    with ThreadPoolExecutor(workers) as threads:
        try:
            while True:
                for prefix in islice(units, 2 * workers - len(at_work)):
                    at_work.add(
                        threads.submit(dearest_of_unit, edges, edges + 1, prefix, transit, halt)
                    )
                if not at_work:
                    return
                done, at_work = wait(at_work, POLL, FIRST_COMPLETED)
                for future in done:
                    listener.progress(sum(part.rooted for part in future.result()))
                    yield future.result()
        finally:
            halt[0] = 1


def _degrees_and_partners(map_: CombinatorialMap) -> tuple[list[int], list[int]]:
    """The map with its darts numbered vertex by vertex; dart 0 stays."""
    order: list[int] = []
    degrees = []
    seen: set[int] = set()
    for dart in map_.darts:
        if map_.vertex_of[dart] not in seen:
            seen.add(map_.vertex_of[dart])
            degrees.append(map_.degree_at[dart])
            order += [map_.turn(dart, i) for i in range(degrees[-1])]
    number = {dart: i for i, dart in enumerate(order)}
    return degrees, [number[map_.alpha[dart]] for dart in order]


def _merged(parts: Iterable[list[Dearest]]) -> dict[int, Dearest]:
    merged: dict[int, Dearest] = {}
    for part in parts:
        for new in part:
            old = merged.get(new.vertices)
            merged[new.vertices] = _joined(old, new) if old else new
    return merged


def _joined(a: Dearest, b: Dearest) -> Dearest:
    """Sums, maxima, and the least of the worlds that attain the worst cost."""
    dearest = min(
        (d for d in (a, b) if d.sigma), key=lambda d: (-d.worst, d.sigma, d.alpha), default=a
    )
    return replace(
        dearest,
        rooted=a.rooted + b.rooted,
        best=max(a.best, b.best),
        tests=a.tests + b.tests,
        wrong=a.wrong + b.wrong,
    )


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
