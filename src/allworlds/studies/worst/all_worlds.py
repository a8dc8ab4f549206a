"""The exact worst and best cost in every world of a class, with the compiled engine."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from typing_extensions import override

from allworlds.engines.dask import Dask
from allworlds.engines.effort import Limits
from allworlds.engines.engine_table import COMPILER, ReadyEngine
from allworlds.engines.here import Threads
from allworlds.engines.job_records import Identity
from allworlds.engines.progress import Listener
from allworlds.engines.single import single_run
from allworlds.engines.sweep import Sweep
from allworlds.engines.units import WHOLE, Portion, SweptLevel, cells_of_level
from allworlds.explorers.loading import load
from allworlds.inputs.checks import InputError, ensure_installed, show
from allworlds.inputs.requests import answers
from allworlds.judging.endings import Answered
from allworlds.judging.episode import default_step_budget, play
from allworlds.judging.findings.rules import AskedRules
from allworlds.judging.laws.bounds import paper_bound
from allworlds.maps.classes import Extent, MapClass
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.outcome import Ending
from allworlds.studies.worst.every_schedule import EverySchedule, Planned
from allworlds.studies.worst.worst_report import WorstReport, WorstRequest, WorstRow
from allworlds.words import size
from allworlds.world.lighthouses.marked import Directional
from allworlds.world.world import World

if TYPE_CHECKING:
    from allworlds.engines.kernel.schedules import ScheduleCosts
    from allworlds.studies.worst.compiled_engine import ScheduleCostsBySize


@answers(WorstRequest)
def worst(request: WorstRequest) -> WorstReport:
    """Find the exact worst and best cost of Algorithm 1 over all worlds and all schedules.

    A compiled search covers every choice of edge, order of hypotheses and path, in all maps of a
    class.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    extent = Extent(request.map_class, request.edges)
    if not extent.map_class.plain:
        raise InputError(
            f"class {show(extent.map_class.value)} is none of those whose maps the compiled search "
            f"makes: {', '.join(known for known in MapClass if known.plain)}"
        )
    ensure_installed(*COMPILER, "worst of algorithm1")
    return SchedulesSweep(request, extent).answer(request.run)


class SchedulesSweep(Sweep["ScheduleCostsBySize", WorstReport]):
    """The sweep of the compiled search through all schedules of Algorithm 1."""

    verb, asked = "worst", WorstRequest
    extent: Extent

    def __init__(self, request: WorstRequest, extent: Extent) -> None:
        from allworlds.studies.worst.compiled_engine import ScheduleCostsBySize

        super().__init__(request, extent)
        self.result = ScheduleCostsBySize  # type: ignore[misc]  # loaded now, with the kernel
        self._subject = load("algorithm1")
        self._rules = AskedRules().rules_of(self._subject, Directional.kind)
        self._rows: list[WorstRow] = []
        self._missing: list[tuple[int, int]] = []

    @override
    @classmethod
    def known(cls, identity: Identity, portion: Portion, listener: Listener) -> SchedulesSweep:
        request = cls.asked_then(identity, portion, listener)
        return cls(request, Extent(request.map_class, request.edges))

    @override
    def explorer(self) -> dict[str, Any]:
        return {"name": self._subject.name}

    @override
    def ready(self) -> ReadyEngine:
        from allworlds.engines.kernel.capabilities import COMPILING
        from allworlds.studies.worst.compiled_engine import ScheduleSearch

        cluster, workers = self.request.cluster, self.request.workers
        engine = ScheduleSearch(self.extent, self.request.transit)
        if not engine.is_compiled():
            self.listener.notice(COMPILING)
        if cluster is not None:
            return ReadyEngine(Dask(cluster, workers, self.deadline), engine)
        return ReadyEngine(Threads(workers, self.deadline), engine)

    @override
    def costs(self, total: ScheduleCostsBySize) -> Iterable[tuple[int, int, int]]:
        return ((len(c.sigma) // 2, n, c.worst) for n, c in total.by_vertices.items())

    @override
    def finish(self, level: SweptLevel, total: ScheduleCostsBySize) -> None:
        whole, edges = self.portion == WHOLE, level.edges
        cells = cells_of_level(self.extent, edges)
        rows = [
            self._row(edges, costs, cells.get(n, 0) if whole else None)
            for n, costs in sorted(total.by_vertices.items())
        ]
        self._rows += rows
        if whole:
            self._missing += ((edges, n) for n, met in cells.items() if met and n not in total)

    @override
    def report(self, ending: Ending) -> WorstReport:
        return WorstReport(
            **self.ended(ending),
            rows=tuple(self._rows),
            disagreement=f"no map with {size(*self._missing[0])} was met" if self._missing else "",
            subject=self._subject,
            rules=self._rules,
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
        """Choices that attain the worst cost, and their cost in the Python engine."""
        schedules = EverySchedule(world.map, world.start, self.request.transit)
        planned = Planned(schedules.most_expensive_picks())
        episode = play(world, self._subject.player(), planned, default_step_budget(bound))
        if not isinstance(episode.ending, Answered):
            return (), None
        choices = tuple(planned.record)
        again = single_run(self._subject, world, self._rules, choices, Limits())
        return choices, again.outcome.cost if again.finding is None else None
