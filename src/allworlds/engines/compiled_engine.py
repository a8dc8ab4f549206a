"""The compiled engine of a check of a built-in explorer, compared with the examiner first.

In small worlds every run is played and judged by itself.  From
:data:`allworlds.engines.engine_table.WALKED_FROM` edges on Algorithm 1 with its directional
lighthouse is walked once in each rooted map, and the walk is counted for every bearing, because the
marker's direction only tells the darts of v0 apart.  That premise, and the kernel itself, are
compared with the examiner, run by run, before the first level; it plays its runs while another
process compiles the kernel.  A broken law is reported only as the examiner finds it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import islice, zip_longest
from typing import Any, Self, TypeAlias

from msgspec import Struct, field

from allworlds.document.struct import replace
from allworlds.engines.engine_table import WALKED_FROM, Job, kind_of, walks
from allworlds.engines.examiner import Examiner
from allworlds.engines.kernel import engine as kernel
from allworlds.engines.kernel.capabilities import COMPILING
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.rows import BrokenRun, Level, Listed, Rows, walk_number
from allworlds.engines.kernel.runs import UNDEFINED, examine
from allworlds.engines.scope import LevelRuns, NumberedRun, Scope, UnitOfRuns, numbered_runs
from allworlds.engines.tally import AtRun, EnginesDisagree, Row, Tally
from allworlds.engines.units import Whole, cells_of_level
from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import InputError
from allworlds.judging.findings.rules import Rules
from allworlds.maps.canonical import Code, rooted_code
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.maps.enumeration import prefixes
from allworlds.protocol.actions import Move
from allworlds.protocol.transcript import Transcript
from allworlds.world.lighthouses.marked import Cluster, Natural
from allworlds.world.world import World

UNBOUNDED = 1 << 40
"""The number in place of no bound: more than any walk costs."""


@cache
def level_of(explorer: str, rules: Rules, extent: Extent, edges: int) -> Level:
    """The kernel's question for a level."""
    return Level(
        edges,
        extent.vertex_limit(edges),
        extent.map_class.simple,
        extent.map_class.planar,
        explorer,
        kind_of(rules.kind),
        rules.policy,
        rules.applying,
        bounds_of(rules, edges),
        (0, *(rules.budget_by_size(n, edges) for n in range(1, edges + 2))),
    )


def bounds_of(rules: Rules, edges: int) -> list[list[list[int]]]:
    """The largest legal costs by vertices, degree of v0 and largest degree, as the kernel's.

    No verdict changes by their limits, as every walk costs 0 or more.
    """

    def value(n: int, d0: int, largest: int) -> int:
        try:
            cost = rules.the_bound.value(n, edges, d0, largest, 0, 0)  # see obstacle
        except InputError:
            return UNDEFINED
        return UNBOUNDED if cost is None else max(-1, min(cost, UNBOUNDED))

    variables, degrees = rules.the_bound.variables, range(2 * edges + 1)
    of_v0, of_all = (degrees if name in variables else range(1) for name in ("d0", "D"))
    return [[[value(n, d0, d) for d in of_all] for d0 in of_v0] for n in range(edges + 2)]


def tally_of(rows: Rows, unit: LevelRuns, scope: Scope, tally: Tally) -> Tally:
    """The empty tally with the kernel's counts, without the events and the findings."""
    most_expensive = {
        n: AtRun(sigma, alpha, place, ()) for n, sigma, alpha, place in rows.most_expensive
    }
    for counts in rows.counts:
        row = tally.row(unit.edges, counts.vertices)
        row.add(
            Row(
                counts.worlds,
                counts.runs,
                counts.runs,
                counts.traversals,
                counts.traversals_rooted,
                counts.largest,
                most_expensive=most_expensive.get(counts.vertices),
            )
        )
        tally.checkpoints += counts.checkpoints
        tally.left_out += counts.left_out
        tally.witnesses["loop-edge"] += counts.loops
        tally.witnesses["parallel-edge"] += counts.parallels
    for n, d0, largest in rows.met:
        # Where a run has a bound without a value, this says so.
        bound = scope.rules.the_bound.value(n, unit.edges, d0, largest, 0, 0)
        tally.row(unit.edges, n).bound_of(bound)
    tally.witnesses = +tally.witnesses  # as the Python engine has them: without zeros
    return tally


AGREEMENT_EDGES = 4
"""The largest m for which a check begins with a comparison of both engines, run by run."""

AGREEMENT_EDGES_SIMPLE = 6
"""The limit in simple classes under lighthouses at two vertices, which few small worlds have."""

Outcomes: TypeAlias = dict[UnitOfRuns, list[Listed]]
"""The listed runs, by unit."""


def listed_runs(scope: Scope, subject: Subject, unit: UnitOfRuns) -> list[Listed]:
    """The list of all runs of a unit; a world without a place is a run without a step."""
    examiner = Examiner(subject, scope.rules)
    return [
        _listed(scope, examiner, run) for run in numbered_runs(unit, scope.extent, scope.rules.kind)
    ]


def _listed(scope: Scope, examiner: Examiner, run: NumberedRun) -> Listed:
    if run.lighthouse is None:
        return Listed("", 0, 0, 0)
    world = World(run.map, run.lighthouse, 0)
    outcome = examiner.examine(world, scope.rules.choices(""))
    episode, broken = outcome.episode, outcome.violation
    return Listed(
        broken.law if broken else "",
        outcome.cost,
        len(episode.checkpoints),
        number_of(episode.transcript),
    )


def number_of(transcript: Transcript) -> int:
    """The hash of a whole walk."""
    return walk_number(
        [
            (action.k, seen.degree, seen.marks, -1 if seen.bearing is None else seen.bearing)
            for action, seen in transcript.steps
            if isinstance(action, Move)
        ]
    )


def compare_engines(scope: Scope, subject: Subject) -> None:
    """Raise EnginesDisagree unless both engines agree on every run in small worlds.

    Where the scope has levels that are walked once for every bearing, the walks are compared
    too: each must cost what the general engine's cost at every bearing.

    Raises:
        EnginesDisagree: naming the first world in which they do not.
    """
    small = replace(scope, coverage=Whole())
    levels = [m for m in scope.extent.levels if m <= compared_to(scope)]
    walked = walks(scope, subject, scope.extent.levels[-1])
    agreed = (subject.name, scope.rules, replace(scope.extent, edges=levels[-1]), walked)
    if agreed in AGREED:
        return
    units = {m: [*_units(small, m)] for m in levels}
    every = [unit for m in levels for unit in units[m]]
    # The general engine plays its runs while the kernel is compiled, by another process.
    with ThreadPoolExecutor(1) as beside:
        compiling = None
        if not is_compiled(examine):
            compiling = beside.submit(kernel.compile_apart, subject.name)
        played: Outcomes = {unit: listed_runs(small, subject, unit) for unit in every}
        if compiling:
            compiling.result()
    kernel.load_judge(level_of(subject.name, small.rules, small.extent, levels[0]))
    compiled = {unit: _judged(small, subject, unit) for unit in every}
    costs = {m: walk_costs(small, subject, m) for m in levels if walked}
    for unit in every:
        _compare_runs(small, unit, played[unit], compiled[unit])
    for m, of_code in costs.items():
        _compare_walks(small, units[m], played, of_code)
    AGREED.add(agreed)


def compared_to(scope: Scope) -> int:
    """The largest m for which both engines are compared."""
    at_two_vertices = issubclass(scope.rules.kind, Cluster | Natural)
    few = scope.extent.map_class.simple and at_two_vertices
    return AGREEMENT_EDGES_SIMPLE if few else AGREEMENT_EDGES


AGREED: set[object] = set()
"""The comparisons that have succeeded in this process."""


def _units(scope: Scope, edges: int) -> Iterator[LevelRuns]:
    """The level, cut by the degree of the root."""
    extent = scope.extent
    for prefix in prefixes(edges, extent.map_class, extent.vertices, depth=1):
        yield LevelRuns(edges, prefix)


def _judged(scope: Scope, subject: Subject, unit: LevelRuns) -> tuple[Listed, ...]:
    """The list of each run of the unit, by the kernel."""
    level = level_of(subject.name, scope.rules, scope.extent, unit.edges)
    runs = sum(counts.runs + counts.left_out for counts in kernel.judge(level, unit.prefix).counts)
    return kernel.judge(level, unit.prefix, listed=runs).listed


def walk_costs(scope: Scope, subject: Subject, edges: int) -> dict[Code, int]:
    """For each world of the level, by its code, the cost of the one walk of the kernel in it.

    Cost: the memory of all of them; meant for m <= 5.
    """
    level = level_of(subject.name, scope.rules, scope.extent, edges)
    room = sum(cells_of_level(scope.extent, edges).values())
    costs = {}
    for unit in _units(scope, edges):
        for cost, degrees, partners in kernel.costs(level, unit.prefix, room):
            costs[rooted_code(rotation(degrees), partners, 0)] = cost
    return costs


def rotation(degrees: Iterable[int]) -> list[int]:
    """The permutation sigma of vertices whose darts are consecutive and clockwise."""
    sigma: list[int] = []
    for degree in degrees:
        first = len(sigma)
        sigma += [*range(first + 1, first + degree), first]
    return sigma


def _compare_runs(
    scope: Scope, unit: LevelRuns, played: Sequence[Listed], judged: Sequence[Listed]
) -> None:
    runs = numbered_runs(unit, scope.extent, scope.rules.kind)
    for run, python, compiled in zip_longest(runs, played, judged):
        if python != compiled:
            if run is None:
                raise EnginesDisagree(f"the kernel has met too many runs in the unit {unit.key}")
            raise EnginesDisagree(
                f"the python engine: {_words(python)}, the kernel: {_words(compiled)}, in the "
                f"world {_world(run)}"
            )


def _compare_walks(
    scope: Scope, units: Iterable[LevelRuns], played: Outcomes, costs: Mapping[Code, int]
) -> None:
    for unit in units:
        runs = numbered_runs(unit, scope.extent, scope.rules.kind)
        for run, python in zip(runs, played[unit], strict=True):
            cost = costs.get(rooted_code(run.map.sigma, run.map.alpha, 0))
            if cost != python.cost:
                walked = "never ends its walk" if cost is None else f"walks {cost} traversals"
                raise EnginesDisagree(
                    f"the kernel {walked}, the python engine {python.cost}, in the world "
                    f"{_world(run)}"
                )


def _words(listed: Listed | None) -> str:
    if listed is None:
        return "no run"
    broken = f"{listed.law} is broken" if listed.law else "all laws hold"
    return f"{listed.cost} traversals, {listed.checkpoints} checkpoints, {broken}"


def _world(run: NumberedRun) -> str:
    return f"sigma={list(run.map.sigma)} alpha={list(run.map.alpha)} place={run.place}"


BATCH = 8
"""Units that a thread does at a time, so that handing them over costs little."""

SYMMETRY = (
    f"from m = {WALKED_FROM} on each rooted map is walked once, at bearing 0, and counted for "
    "every bearing: the walk does not depend on it, as the python engine confirms on every "
    f"bearing up to m = {AGREEMENT_EDGES}"
)


class CompiledEngine(Struct, frozen=True):
    """The engine in which the kernel plays and judges, or walks, all runs of a unit.

    Attributes:
        scope, subject, keep: as for the general engine.
        flag: its entry 0 tells the kernel to give up.
        reached: by edges and vertices, the cost of some walk: a cheaper run is not the most
            expensive.
    """

    scope: Scope
    subject: Subject
    keep: int
    flag: Any = field(default_factory=kernel.flag)
    reached: dict[int, Any] = field(default_factory=dict)

    @classmethod
    def ready(cls, job: Job) -> Self:
        """The engine, after it has been compared with the general one.

        Raises:
            EnginesDisagree: naming the first world in which they do.
        """
        if not is_compiled(examine):
            job.notice(COMPILING)
        compare_engines(job.scope, job.subject)
        return cls(job.scope, job.subject, job.keep)

    def halt(self) -> None:
        """Make all threads give up their work."""
        self.flag[0] = 1

    def parts(self, unit: LevelRuns) -> Iterator[Tally]:
        """The tally of the unit, equal to the general engine's.

        Raises:
            EnginesDisagree: if the general engine does not confirm a broken law.
            InputError: for a bound that has no value in a world.
        """
        scope = self.scope
        level = level_of(self.subject.name, scope.rules, scope.extent, unit.edges)
        if walks(scope, self.subject, unit.edges):
            known = self.reached.setdefault(unit.edges, kernel.reached_in(unit.edges))
            rows = kernel.walk(level, unit.prefix, keep=self.keep, reached=known, halt=self.flag)
        else:
            rows = kernel.judge(level, unit.prefix, keep=self.keep, halt=self.flag)
        yield self._tally(unit, rows)

    def _tally(self, unit: LevelRuns, rows: Rows) -> Tally:
        tally = tally_of(rows, unit, self.scope, Tally(self.keep))
        tally.witnesses.update(rows.events)
        tally.witnesses = +tally.witnesses
        for broken in rows.broken:
            self._blame(broken, tally)
        return tally

    def _blame(self, broken: BrokenRun, tally: Tally) -> None:
        """Find the runs by the general engine in which the kernel finds a law broken.

        Raises:
            EnginesDisagree: if the general engine finds another law broken, or none.
        """
        try:
            map_ = CombinatorialMap(broken.sigma, broken.alpha)
        except InvalidMap as error:
            raise EnginesDisagree(f"the kernel met a world that is none: {error}") from None
        rules = self.scope.rules
        examiner = Examiner(self.subject, rules)
        places = enumerate(rules.kind.places(map_, 0))
        only = slice(None) if broken.place is None else slice(broken.place, broken.place + 1)
        for place, lighthouse in islice(places, only.start, only.stop):
            world = World(map_, lighthouse, 0)
            outcome = examiner.examine(world, rules.choices(""))
            law = outcome.violation.law if outcome.violation else ""
            if not law or broken.law not in ("", law):
                raise EnginesDisagree(
                    f"the kernel says that {broken.law or 'a law'} is broken, the python engine "
                    f"that {law or 'none'} is, in the world sigma={list(map_.sigma)} "
                    f"alpha={list(map_.alpha)} place={place}"
                )
            tally.find(examiner.finding(world, place, outcome))
