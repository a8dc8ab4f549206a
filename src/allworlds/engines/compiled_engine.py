"""The compiled engine, which checks built-in explorers, after a comparison with the Python engine.

The kernel is the compiled code.  In small worlds the kernel plays and judges every run.  In levels
of :data:`allworlds.engines.engine_table.WALKED_FROM` edges or more it walks Algorithm 1 under the
directional lighthouse only once in each rooted map, although the map has a run for each direction
of the marker.  This one walk is counted for all of these runs: Algorithm 1 uses the direction only
to tell the darts of v0 apart, so its walk is the same for each direction.

Before the first level the Python engine plays all small worlds, while another process compiles the
kernel.  Then the counts of the kernel must equal those of the Python engine.  They are compared
twice: after the kernel has played every run, and after it has walked each map once.  The report
names a broken law only if the Python engine finds that the law is broken, too.
"""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import islice
from typing import Any, Self

from msgspec import Struct, field

from allworlds.documents.document import replace
from allworlds.engines import linux
from allworlds.engines.engine_table import WALKED_FROM, Job, kind_of, walks
from allworlds.engines.kernel import arrays, capabilities, engine as kernel, library_player
from allworlds.engines.kernel.compiling import is_compiled, uncollected
from allworlds.engines.kernel.runs import UNDEFINED, examine
from allworlds.engines.tally import AtRun, EnginesDisagree, Row, RunCounter, Tally
from allworlds.engines.units import LevelUnit, Scope, UnitOfRuns
from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import InputError
from allworlds.judging.laws.law_table import LAWS
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.maps import classes, combinatorial, enumeration
from allworlds.world.lighthouses.marked import Cluster, Natural
from allworlds.world.world import World

UNBOUNDED = 1 << 40
"""The number that stands for no bound; no walk costs that much."""


@cache
def level_of(explorer: str, rules: Rules, extent: classes.Extent, edges: int) -> arrays.Level:
    """The request to the kernel for a level: number of edges, explorer, rules, bounds and budgets.

    Args:
        explorer: the explorer's name; for a user's explorer the kernel only judges logs.
        rules: the rules of the runs.
        extent: the class of maps, and the bound on the vertices.
        edges: the number of edges of the level.
    """
    return arrays.Level(
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
    """The largest legal cost for each size of maps, as nested lists.

    Item ``[n][d0][D]`` is the cost for maps with n vertices, degree d0 of v0 and largest degree D.
    If the bound does not depend on one of these degrees, the list for this degree has one item.  A
    cost below -1 is replaced by -1, and a cost above :data:`UNBOUNDED` by UNBOUNDED; this changes
    no verdict, because every walk costs more than -1 and less than UNBOUNDED. The item is
    ``UNDEFINED`` if the bound has no value, for example because it divides by 0.

    Args:
        rules: the rules of the runs, with the bound.
        edges: the number of edges of the maps.
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


def tally_of(sums: arrays.Sums, unit: LevelUnit, scope: Scope, tally: Tally) -> Tally:
    """Add the kernel's counts of a unit to the empty tally, and return the tally.

    Two witnesses are added: the number of worlds with a loop, and that of worlds with parallel
    edges.  The events of Algorithm 1 in ``sums.events`` are not added, and no findings are.

    Args:
        sums: the kernel's results for the unit.
        unit: the unit.
        scope: the scope; from its bound follows the largest legal cost in each row of the tally.
        tally: the empty tally.

    Raises:
        InputError: if the bound has no value in a world of the unit, for example because it divides
            by 0 there.
    """
    most_expensive = {
        n: AtRun(sigma, alpha, place, ()) for n, sigma, alpha, place in sums.most_expensive
    }
    for counts in sums.counts:
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
                fingerprint=counts.fingerprint,
            )
        )
        tally.checkpoints += counts.checkpoints
        tally.left_out += counts.left_out
        tally.witnesses["loop-edge"] += counts.loops
        tally.witnesses["parallel-edge"] += counts.parallels
    for n, d0, largest in sums.met:
        # If the bound of a run has no value, this raises InputError.
        bound = scope.rules.the_bound.value(n, unit.edges, d0, largest, 0, 0)
        tally.row(unit.edges, n).bound_of(bound)
    tally.witnesses = +tally.witnesses  # without zeros, as in the Python engine
    return tally


AGREEMENT_EDGES = 4
"""The largest m of the worlds in which both engines are compared before a check begins."""

AGREEMENT_EDGES_SIMPLE = 6
"""The largest m of the worlds in which both engines are compared before a check begins, if the
class is simple and the lighthouse has marks at two vertices."""


def compare_engines(scope: Scope, subject: Subject) -> None:
    """Raise EnginesDisagree unless both engines have equal results in each small world.

    A world is small if it has at most :func:`compared_to` edges.  If in some level of the scope one
    walk in a map is counted for every direction of the marker, two counts are compared in each
    small map, too: the count after one walk, and the count after a run for each direction.

    Raises:
        EnginesDisagree: naming the first world in which the results differ.
    """
    extent = scope.extent
    levels = [m for m in extent.levels if m <= compared_to(scope)]
    walked = walks(scope, subject, extent.levels[-1])
    agreed = (subject.name, scope.rules, replace(extent, edges=levels[-1]), walked)
    if agreed in AGREED:
        return
    worlds = [
        LevelUnit(m, history)
        for m in levels
        for history in enumeration.prefixes(m, extent.map_class, extent.vertices, depth=2 * m)
    ]
    # The general engine plays its runs while another process compiles the kernel.
    with ThreadPoolExecutor(1) as beside, linux.compilers_ended():
        compiling = None
        if not is_compiled(examine):
            compiling = beside.submit(kernel.compile_apart, subject.name)
        played = [played_tally(scope, subject, world) for world in worlds]
        if compiling:
            compiling.result()
    with uncollected():
        for world, python in zip(worlds, played, strict=True):
            _compare_in(world, python, scope, subject, walked=walked)
    AGREED.add(agreed)


def _compare_in(
    world: LevelUnit, python: Tally, scope: Scope, subject: Subject, *, walked: bool
) -> None:
    level = level_of(subject.name, scope.rules, scope.extent, world.edges)
    sums = kernel.judge(level, world.prefix, keep=len(LAWS))
    compare(tally_of(sums, world, scope, Tally(1)), sums, python, world)
    broken, laws = {one.law for one in sums.broken}, {one.law for one in python.findings}
    if broken != laws:
        said = f"that {broken or 'no law'} is broken, the python engine {laws or 'none'}"
    elif walked and kernel.walk(level, world.prefix).counts != sums.counts:
        said = f"one walk for every bearing, {sums.counts} run by run"
    else:
        return
    (map_,) = world.maps(scope.extent)
    raise EnginesDisagree(
        f"the kernel says {said}, in the world sigma={list(map_.sigma)} alpha={list(map_.alpha)}"
    )


def played_tally(scope: Scope, subject: Subject, unit: UnitOfRuns) -> Tally:
    """The tally that the Python engine makes of a unit, with a finding for each broken law."""
    counter, examiner = RunCounter(scope, keep=len(LAWS)), Examiner(subject, scope.rules)
    tally = counter.tally()
    for run in counter.runs(unit):
        world = counter.count_run(run, tally)
        if world is not None:
            outcome = examiner.examine(world, scope.rules.choices(""))
            counter.count_outcome(world, run.place, outcome, tally)
            counter.settle(examiner, world, run.place, outcome, tally)
    return tally


def compare(kernels: Tally, sums: arrays.Sums, pythons: Tally, unit: LevelUnit) -> None:
    """Raise EnginesDisagree unless the kernel and the Python engine have equal counts in a unit.

    Args:
        kernels: the counts of the kernel.
        sums: the results from which ``kernels`` was made; the error shows their broken runs.
        pythons: the counts of the Python engine.
        unit: the unit.
    """
    if _counts_of(kernels) != _counts_of(pythons):
        raise EnginesDisagree(
            f"the kernel and the python engine count differently in the unit {unit.key}: "
            f"{_counts_of(kernels)} and {_counts_of(pythons)}; broken: {sums.broken}"
        )


def _counts_of(tally: Tally) -> object:
    """The counts of a tally that must be equal in both engines, as a value to be compared."""
    sizes = sorted(tally.rows.items())
    most = [(size, row.most_expensive and row.most_expensive[:3]) for size, row in sizes]
    return [row for _, row in sizes], most, tally.left_out, tally.checkpoints, +tally.witnesses


def compared_to(scope: Scope) -> int:
    """The largest number of edges of the worlds in which both engines are compared."""
    at_two_vertices = issubclass(scope.rules.kind, Cluster | Natural)
    few = scope.extent.map_class.simple and at_two_vertices
    return AGREEMENT_EDGES_SIMPLE if few else AGREEMENT_EDGES


AGREED: set[object] = set()
"""The comparisons of both engines that have already succeeded in this process.

An element of this set is a comparison: the explorer, the rules, the extent, and whether the kernel
has also walked each map once for all bearings.
"""


BATCH = 8
"""The number of units that a thread gets at a time.

The smaller this number is, the more time the exchange with the threads takes.
"""

SYMMETRY = (
    f"from m = {WALKED_FROM} on each rooted map is walked once, at bearing 0, and counted for "
    "every bearing: the walk does not depend on it, as the python engine confirms on every "
    f"bearing up to m = {AGREEMENT_EDGES}"
)


class CompiledEngine(Struct, frozen=True):
    """The engine in which the kernel plays and judges every run of a unit of a built-in explorer.

    In a level for which :func:`walks` is true, the kernel instead walks each map once, and counts
    the walk for every bearing.

    Attributes:
        scope, subject, keep: the scope, the explorer, and the number of findings to be kept.
        flag: an array of one number; once this number is not 0, the kernel gives up its work.
    """

    scope: Scope
    subject: Subject
    keep: int
    flag: Any = field(default_factory=kernel.flag)

    @classmethod
    def ready(cls, job: Job) -> Self:
        """The compiled engine, after it has been compared with the Python engine.

        Raises:
            EnginesDisagree: naming the first world in which the engines differ.
        """
        if not is_compiled(examine):
            job.notice(capabilities.COMPILING)
        compare_engines(job.scope, job.subject)
        return cls(job.scope, job.subject, job.keep)

    def halt(self) -> None:
        """Stop the work of all threads."""
        self.flag[0] = 1

    def parts(self, unit: LevelUnit) -> Iterator[Tally]:
        """Yield one part: the tally of the unit, which equals the tally that Python would make.

        Raises:
            EnginesDisagree: if the Python engine does not confirm a broken law.
            InputError: if the bound has no value in a world of the unit.
        """
        scope = self.scope
        level = level_of(self.subject.name, scope.rules, scope.extent, unit.edges)
        does = kernel.walk if walks(scope, self.subject, unit.edges) else kernel.judge
        sums = does(level, unit.prefix, keep=self.keep, halt=self.flag)
        tally = tally_of(sums, unit, scope, Tally(self.keep))
        tally.witnesses.update(sums.events)
        tally.witnesses = +tally.witnesses
        for broken in sums.broken:
            self._blame(broken, tally)
        yield tally

    def _blame(self, broken: arrays.BrokenRun, tally: Tally) -> None:
        """Let the Python engine play again a run that breaks a law, as the kernel has found.

        The finding that the Python engine makes is added to the tally.

        Args:
            broken: the run; if its place is None, all runs of the map are played again.
            tally: the tally of the unit.

        Raises:
            EnginesDisagree: if the Python engine finds that another law is broken, or that none is.
        """
        try:
            map_ = combinatorial.CombinatorialMap(broken.sigma, broken.alpha)
        except combinatorial.InvalidMap as error:
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


def load_native() -> None:
    """Load or compile the code that judges logs, and the code that plays shared libraries.

    Each kind of lighthouse has compiled code of its own.  Of this code, only that of the
    directional lighthouse is loaded here; a judge loads or compiles that of another kind later.
    """
    level = level_of("", Rules(), classes.Extent(classes.MapClass.MAPS, 1), 1)
    with uncollected():
        stretch = arrays.Stretch.of(level.edges)
        unit = kernel.UnitJudge(level, (-1,), 1, stretch, stretch)
        unit.judge(unit.lay_out(0), 0)
        library_player.load_player()


def is_kept() -> bool:
    """Whether the code that :func:`load_native` loads is already compiled, and kept on disk."""
    return all(map(is_compiled, (library_player.play, examine)))


def compile_apart() -> None:
    """Start a process of low priority that calls :func:`load_native`; do not wait for its end."""
    code = f"import os; os.nice(19); from {__name__} import load_native; load_native()"
    kernel.in_another_process(code)
