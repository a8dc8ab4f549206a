"""The exact worst and best cost of Algorithm 1 in every world of a class, by a compiled search."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args

from typing_extensions import override

from allworlds import outcome, words
from allworlds.documents import document as doc
from allworlds.engines import limits, single, sweep, units
from allworlds.engines.engine_table import COMPILER, ReadyEngine, local_or_dask
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.loading import Subject, load
from allworlds.explorers.sources import DEFAULT_EXPLORER
from allworlds.inputs.checks import (
    InputError,
    a_word,
    ensure_installed,
    integer_of,
    show,
)
from allworlds.inputs.requests import RULES, SCOPE, Argument, Converted, Option, Request, answers
from allworlds.judging.episode import Answered, play
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.bounds import default_step_budget, paper_bound
from allworlds.judging.rules import RuleOptions, Rules
from allworlds.maps import classes, combinatorial
from allworlds.notations.given import GivenOptions
from allworlds.studies.scopes import FileDigests, GivenCount, as_scope
from allworlds.studies.swept import SweptOptions, SweptReport, ToldGate
from allworlds.studies.worst.every_schedule import EverySchedule, Planned, Transit
from allworlds.world.lighthouses.kinds import LighthouseKind
from allworlds.world.lighthouses.marked import Directional
from allworlds.world.selection import LighthouseOptions
from allworlds.world.world import World

if TYPE_CHECKING:
    from allworlds.engines.kernel.schedules import ScheduleCosts
    from allworlds.studies.worst.compiled_engine import ScheduleCostsBySize

DEFAULT_EDGES, MOST_EDGES = 5, 12


def _algorithm1(given: object) -> str:
    if given not in (DEFAULT_EXPLORER, algorithm1):
        raise InputError(
            f"worst is of {DEFAULT_EXPLORER}, not of {show(given)}; 'allworlds check EXPLORER "
            "--schedules all' has the best and the largest cost of any other"
        )
    return DEFAULT_EXPLORER


class Algorithm1Option(Request, kw_only=False):
    """The part of a request of ``worst`` that names the explorer: Algorithm 1 is the only one."""

    explore: Annotated[
        Converted[str | Callable[..., Any], str],
        Argument(
            "",
            "[EXPLORER]",
            "Only algorithm1; for any other explorer, check EXPLORER --schedules all has the "
            "costs.",
        ),
    ] = Converted(_algorithm1, DEFAULT_EXPLORER)


class WorstRequest(
    SweptOptions, limits.WorkerOptions, GivenOptions, classes.ClassOptions, Algorithm1Option
):
    """Request of ``worst``: the worlds, the paths that Algorithm 1 may take, and the effort."""

    edges: Annotated[
        int | None,
        Option(
            SCOPE,
            "M",
            f"At most M edges [default: {DEFAULT_EDGES}; of given worlds any].",
            parse=integer_of,
            document_type=Annotated[doc.Positive, doc.about("at most so many")],
        ),
    ] = None
    transit: Annotated[
        Converted[str, Transit],
        Option(
            RULES,
            "|".join(get_args(Transit)),
            "How Algorithm 1 goes to the next edge: on a shortest or on any simple path.",
            document_type=Annotated[
                Transit, doc.about("the paths by which Algorithm 1 goes to the next edge")
            ],
        ),
    ] = Converted(a_word("transit", get_args(Transit)), "simple")

    @property
    def extent(self) -> classes.Extent:
        """The maps that are searched: a class with its bounds, or the given maps.

        Raises:
            InputError: naming a bound that is too large, or a lighthouse of given worlds that is
                not the directional one.
        """
        self.lighthouse_of_given(LighthouseKind(Directional.kind))
        usual = self.edges is None and self.given is None
        edges = DEFAULT_EDGES if usual else self.edges
        extent = classes.Extent(self.map_class, edges, given=self.given)
        if (most := extent.levels[-1]) > MOST_EDGES:
            raise InputError(f"edges = {show(most)}, but there is room for {MOST_EDGES} at most")
        return extent


class WorstRow(doc.Document):
    """The costs of all schedules in the worlds of one size.

    ``counted`` is the number of rooted maps according to the independent source; None in a shard,
    or for given worlds.
    """

    edges: doc.Edges
    vertices: doc.Vertices
    worlds: Annotated[doc.Positive, doc.about("rooted maps")]
    worst: Annotated[doc.Natural, doc.about("the largest cost of a schedule")]
    best: Annotated[
        doc.Natural, doc.about("the cheapest schedule of each world: the largest of their costs")
    ]
    bound: Annotated[int | None, doc.about("the largest bound in a world; null without a bound")]
    tests: Annotated[doc.Natural, doc.about("different tests of false hypotheses")]
    wrong_tests: Annotated[doc.Natural, doc.about("tests that confirmed a false hypothesis")]
    world: Annotated[World, doc.about("the smallest world in which a run costs `worst`")]
    choices: Annotated[tuple[doc.Natural, ...], doc.about("the choices of such a run there")]
    replayed: Annotated[
        doc.Natural | None, doc.about("cost of this run in the Python engine; null: a broken law")
    ]
    counted: doc.NotInDocument[int | None]

    @property
    def agrees(self) -> bool:
        """Whether the search agrees with the independent count, and with a run that is replayed.

        The replayed run must have the worst cost.  If a test has confirmed a false hypothesis, no
        run is replayed, and the count alone decides.
        """
        counted = self.counted in (None, self.worlds)
        return counted and (bool(self.wrong_tests) or self.replayed == self.worst)

    @property
    def refutes(self) -> bool:
        """Whether a test has confirmed a false hypothesis, or the worst cost exceeds the bound."""
        return bool(self.wrong_tests) or (self.bound is not None and self.worst > self.bound)


@doc.with_options(classes.ClassOptions, LighthouseOptions, WorstRequest, RuleOptions)
class WorstScope(doc.Document):
    """The scope of a search for the worst case."""

    schedules: Annotated[Literal["all"], doc.about("every schedule was searched")]
    symmetry: Annotated[doc.Text, doc.about("why one world stands for every direction")]
    given: GivenCount
    sha256: FileDigests
    shard: doc.WhichShard


class WorstReport(SweptReport, kw_only=True):
    """Report of 'worst'.

    The worst and best costs of Algorithm 1, by size.

    Each row is compared with an independent source of counts.  A size (edges and vertices) without
    maps in the search has no row.  If the source counts maps of such a size, ``disagreement`` is a
    sentence that names the size; otherwise this text is empty.  ``subject`` is Algorithm 1.  For
    each row a run with the worst cost is played in the Python engine; ``rules`` are the rules of
    these runs.
    """

    rows: Annotated[tuple[WorstRow, ...], doc.about("one for each (edges, vertices), ascending")]
    findings: Annotated[tuple[Finding, ...], doc.about("always empty: see `wrong_tests`")] = ()
    subject: doc.NotInDocument[Subject]
    rules: doc.NotInDocument[Rules]
    disagreement: doc.NotInDocument[str] = ""

    @doc.computed
    def explorer(self) -> doc.Text:
        """The name of the explorer."""
        return self.subject.name

    @doc.computed
    def scope(self) -> WorstScope:
        """A description of all that was searched."""
        return as_scope(
            WorstScope,
            self.request,
            self.rules,
            edges=self.extent.edges,
            schedules="all",
            symmetry="one world for each start vertex: every choice of dart is tried, so the dart "
            "faced at the start and the bearing make no difference",
        )

    @doc.computed
    def gate(self) -> ToldGate:
        """The count gate; null if there is nothing to compare."""
        return self.compared

    @property
    @override
    def agrees(self) -> bool:
        return not self.disagreement and all(row.agrees for row in self.rows)

    @property
    @override
    def refuted(self) -> bool:
        return any(row.refutes for row in self.rows)

    def walks(self) -> Iterator[single.SingleRun]:
        """Play again, for each row, the run that attains the worst cost, and yield this run.

        Rows without such a run are left out.
        """
        for row in self.rows:
            if row.replayed is not None:
                yield single.single_run(
                    self.subject, row.world, self.rules, row.choices, limits.Limits()
                )


@answers(WorstRequest)
def worst(request: WorstRequest) -> WorstReport:
    """Find the exact worst and best cost of Algorithm 1 over all worlds and all schedules.

    A compiled search covers every choice of edge, order of hypotheses and path, in all maps of a
    class.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    return SchedulesSweep(request).answer(request.run)


class SchedulesSweep(sweep.Sweep["ScheduleCostsBySize", WorstReport]):
    """The sweep of the compiled search through all schedules of Algorithm 1."""

    verb, request_type = "worst", WorstRequest
    extent: classes.Extent

    def __init__(self, request: WorstRequest) -> None:
        super().__init__(request, request.extent)
        ensure_installed(*COMPILER, "worst of algorithm1")
        from allworlds.studies.worst.compiled_engine import ScheduleCostsBySize

        self.result = ScheduleCostsBySize  # type: ignore[misc]  # loaded now, with the kernel
        self._subject = load("algorithm1")
        self._rules = RuleOptions().rules_of(self._subject, Directional.kind)
        self._rows: list[WorstRow] = []
        self._missing = ""

    @override
    def explorer(self) -> dict[str, Any]:
        return {"name": self._subject.name}

    @override
    def ready(self) -> ReadyEngine:
        from allworlds.engines.kernel.capabilities import COMPILING
        from allworlds.engines.kernel.compiling import is_compiled
        from allworlds.engines.kernel.schedules import search
        from allworlds.studies.worst.compiled_engine import ScheduleSearch

        if not is_compiled(search):
            self.listener.notice(COMPILING)
        there = local_or_dask(self.request.dask, self.deadline, self.request.workers)
        return ReadyEngine(there, ScheduleSearch(self.extent, self.request.transit))

    @override
    def costs(self, total: ScheduleCostsBySize) -> Iterable[tuple[int, int, int]]:
        return ((len(c.sigma) // 2, n, c.worst) for n, c in total.by_vertices.items())

    @override
    def finish(self, level: units.SweptLevel, total: ScheduleCostsBySize) -> None:
        whole, edges, rows = self.portion == units.WHOLE, level.edges, total.by_vertices
        cells = {} if self.extent.given else units.cells_of_level(self.extent, edges)
        for n, costs in sorted(rows.items()):
            counted = cells.get(n, 0) if whole and cells else None
            self._rows.append(self._row(edges, costs, counted))
        for n, counted in cells.items():
            if whole and counted and n not in rows and not self._missing:
                self._missing = f"no map with {words.size(edges, n)} was met"

    @override
    def report(self, ending: outcome.Ending) -> WorstReport:
        return WorstReport(
            **self.ended(ending),
            rows=tuple(self._rows),
            disagreement=self._missing,
            subject=self._subject,
            rules=self._rules,
        )

    def _row(self, edges: int, costs: ScheduleCosts, counted: int | None) -> WorstRow:
        bound = paper_bound(costs.vertices, edges)
        world = World(combinatorial.CombinatorialMap(costs.sigma, costs.alpha), Directional(0), 0)
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
        """Choices that attain the worst cost in a world, and the cost of a run with these choices.

        The run is played in the Python engine; its cost is None if the run breaks a law.  ``bound``
        is the paper's bound on the traversals in this world; a run is cut off after
        ``default_step_budget(bound)`` traversals.  If the run ends without an answer, which shows a
        fault, there are no choices, and the cost is None.
        """
        schedules = EverySchedule(world.map, world.start, self.request.transit)
        planned = Planned(schedules.most_expensive_picks())
        episode = play(world, self._subject.player(), planned, default_step_budget(bound))
        if not isinstance(episode.ending, Answered):
            return (), None
        choices = tuple(planned.record)
        again = single.single_run(self._subject, world, self._rules, choices, limits.Limits())
        return choices, again.outcome.cost if again.finding is None else None
