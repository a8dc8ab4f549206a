"""The kill matrix: which check kills which mutant, at which smallest world."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import Annotated, Any, Literal, TypeAlias

from typing_extensions import override

from allworlds.document import (
    Different,
    Document,
    Natural,
    Positive,
    Text,
    about,
    computed,
    replace,
)
from allworlds.engines import AskedListener, Listener, RowsReport
from allworlds.evidence.mutants.enumerators import BROKEN_ENUMERATORS, BrokenEnumerator
from allworlds.evidence.mutants.errands import (
    WEAK_TASK_JUDGES,
    WRONG_ERRANDS,
    WeakTaskJudge,
    WrongErrand,
)
from allworlds.evidence.mutants.explorers import (
    EQUIVALENT_EXPLORERS,
    WRONG_EXPLORERS,
    WrongExplorer,
)
from allworlds.evidence.mutants.judges import WEAK_JUDGES, WeakJudge
from allworlds.evidence.mutants.learners import WRONG_LEARNERS, WrongLearner
from allworlds.explorers import in_process_subject
from allworlds.inputs import (
    SCOPE,
    InputError,
    Option,
    Taken,
    an_integer,
    answers,
    integer_of,
    show,
)
from allworlds.judging import (
    LAWS,
    Answered,
    Case,
    Setting,
    Undecided,
    any_ending_of,
    canonical_world,
    default_step_budget,
    judge,
    paper_bound,
    play,
    task_named,
)
from allworlds.maps import (
    CombinatorialMap,
    rooted_code,
    rooted_maps,
    rooted_maps_by_permutations,
    source_for,
)
from allworlds.outcome import until_interrupted
from allworlds.protocol import Choices
from allworlds.studies.check import check
from allworlds.world import Directional, World, lighthouse_named

LARGEST_LEVEL = 4
"""The dumb enumerator, which some mutants need, goes no further in reasonable time."""


MutantKind: TypeAlias = Literal["explorer", "judge", "enumerator"]
"""The kinds of mutants."""


class Kill(Document):
    """The fate of one mutant.

    A mutant whose plays differ has no world: the world at which it is seen depends on the order in
    which it meets the worlds.
    """

    mutant: Annotated[Text, about("its name")]
    kind: Annotated[MutantKind, about("its kind")]
    breaks: Annotated[Text, about("its mistake")]
    killed_by: Annotated[
        str | None, about("the law or the check that killed it; null: it survived")
    ] = None
    world: Annotated[
        World | None,
        about("the smallest world that kills it; null: it survived, or any may kill it"),
    ] = None
    equivalent: Annotated[str | None, about("why it may survive; null: it may not")] = None

    @property
    def as_it_should(self) -> bool:
        """Whether it is killed, or alive and equivalent."""
        return bool(self.killed_by) != bool(self.equivalent)


class KillMatrix(RowsReport):
    """Report of 'mutants'.

    The fate of every mutant within a bound.
    """

    edges: Annotated[Positive, about("at most so many")]
    mutants: Annotated[Natural, about("how many there are")] = computed(
        lambda matrix: len(matrix.kill_matrix)
    )
    kill_matrix: Annotated[tuple[Kill, ...], about("one a mutant")]
    survivors: Annotated[
        Different[Text], about("mutants that survive but must not, or should survive but do not")
    ] = computed(lambda matrix: tuple(k.mutant for k in matrix.kill_matrix if not k.as_it_should))

    @property
    @override
    def refuted(self) -> bool:
        return bool(self.survivors)


def _level(given: int) -> int:
    if not 1 <= (edges := an_integer("edges", given)) <= LARGEST_LEVEL:
        raise InputError(f"edges = {show(edges)}; mutants are tried up to 1..{LARGEST_LEVEL} edges")
    return edges


class MutantsRequest(AskedListener):
    """Request of ``self mutants``: the bound."""

    edges: Annotated[
        Taken[int, int],
        Option(SCOPE, "M", "Try worlds with at most M edges (1 to 4).", parse=integer_of),
    ] = Taken(_level, LARGEST_LEVEL)


@answers(MutantsRequest)
def mutants(request: MutantsRequest) -> KillMatrix:
    """Try every mutant on every world within the bound.

    Raises:
        InputError: for a bound that is not 1, 2, 3 or 4.

    Cost: seconds for 3 edges; every equivalent mutant is run to the bound.
    """
    edges, heard = request.edges, request.listener
    explorers = (_wrong(), WRONG_ERRANDS, EQUIVALENT_EXPLORERS)
    tables = (*explorers, WEAK_JUDGES, WEAK_TASK_JUDGES, BROKEN_ENUMERATORS)
    heard.stage("mutants", sum(map(len, tables)), "mutants")
    kills, ending = until_interrupted(_told(_kills(edges), heard))
    return KillMatrix(edges=edges, ending=ending, kill_matrix=kills)


def _wrong() -> tuple[WrongExplorer | WrongLearner, ...]:
    """Explorers of maps that must be killed."""
    return (*WRONG_EXPLORERS, *WRONG_LEARNERS)


def _told(kills: Iterable[Kill], listener: Listener) -> Iterator[Kill]:
    for kill in kills:
        yield kill
        listener.progress(1)


def _kills(edges: int) -> Iterator[Kill]:
    refuted = []
    for mutant in (*_wrong(), *WRONG_ERRANDS, *EQUIVALENT_EXPLORERS):
        kill = _explorer(mutant, edges)
        refuted += [kill.mutant] if kill.killed_by in (*LAWS, "ambiguity") else []
        yield kill
    yield from _judges(WEAK_JUDGES, lambda level: _refused(level, refuted), edges)
    yield from _judges(WEAK_TASK_JUDGES, _refused_errands, edges)
    for broken in BROKEN_ENUMERATORS:
        yield _enumerator(broken, edges)


def _explorer(mutant: WrongExplorer | WrongLearner | WrongErrand, edges: int) -> Kill:
    """Kill an explorer by the law that an ordinary check finds broken first."""
    explore = mutant.explorer()
    report = check(explore, edges=edges, lighthouse=mutant.lighthouse, task=mutant.task)
    report = report.uninterrupted()
    row = Kill(
        mutant=mutant.name,
        kind="explorer",
        breaks=mutant.breaks,
        equivalent=mutant.equivalent or None,
    )
    if not report.findings:
        return row
    finding = report.findings[0]
    world = None if finding.law == "nondeterministic" else finding.world
    return replace(row, killed_by=finding.law, world=world)


def _judges(
    judges: Sequence[WeakJudge] | Sequence[WeakTaskJudge],
    refused: Callable[[int], Iterator[_Refused]],
    edges: int,
) -> Iterator[Kill]:
    """Kill each weak judge by the smallest case that only the sound judge refuses.

    Cases come from the explorers that are known to answer wrongly.
    """
    alive: dict[str, Any] = {weak.name: weak for weak in judges}
    killed: dict[str, tuple[str, World]] = {}
    for level in range(1, edges + 1):
        smallest: dict[str, tuple[Any, str, World]] = {}
        for run, world, name in refused(level) if alive else ():
            for weak in alive.values():
                if weak.accepts(*run):
                    canonical = canonical_world(world)
                    key = (world.map.vertex_count, *_code(canonical.map), name)
                    if weak.name not in smallest or key < smallest[weak.name][0]:
                        smallest[weak.name] = (key, name, canonical)
        for weak_name, (_, explorer, world) in smallest.items():
            killed[weak_name] = (f"sound judge on {explorer}", world)
            del alive[weak_name]
    for weak in judges:
        by, smallest_world = killed.get(weak.name, (None, None))
        yield Kill(
            mutant=weak.name, kind="judge", breaks=weak.breaks, killed_by=by, world=smallest_world
        )


_Refused: TypeAlias = tuple[tuple[Any, ...], World, str]
"""A run that the sound judge refuses, as weak judges get it; its world, and who was run."""


def _refused_errands(level: int) -> Iterator[_Refused]:
    """Runs of the explorers with other tasks, one a rooted map, that do not do them."""
    for mutant in WRONG_ERRANDS:
        kind, task = lighthouse_named(mutant.lighthouse), task_named(mutant.task)
        player = in_process_subject(mutant.explorer()).player()
        for map_ in rooted_maps(level):
            world = World(map_, next(iter(kind.places(map_, 0))), 0)
            budget = default_step_budget(paper_bound(map_.vertex_count, level))
            there = task.environment(world)
            episode = play(there, player, Choices(), budget, ended=any_ending_of)
            if task.flaw(world, episode.transcript, episode.ending):
                yield (task, world, episode.transcript), world, mutant.name


def _refused(level: int, explorers: Collection[str]) -> Iterator[_Refused]:
    """Runs of those explorers, one a rooted map, whose answer breaks a law that applies."""
    players = [
        (
            mutant.name,
            lighthouse_named(mutant.lighthouse),
            in_process_subject(mutant.explorer()).player(),
        )
        for mutant in _wrong()
        if mutant.name in explorers
    ]
    for map_ in rooted_maps(level):
        bound = paper_bound(map_.vertex_count, level)
        for name, kind, player in players:
            setting = Setting(kind.folds, bounded=kind.default_bound == "paper")
            laws = {law: LAWS[law].check for law in LAWS if LAWS[law].applies(setting)}
            world = World(map_, next(iter(kind.places(map_, 0))), 0)
            episode = play(world, player, Choices(), default_step_budget(bound))
            match episode.ending:
                case Answered(estimate=answer) | Undecided(quotient=answer):
                    case = Case(
                        world.map,
                        world.start,
                        episode.transcript,
                        episode.checkpoints,
                        answer,
                        bound if setting.bounded else None,
                    )
                    if judge(case, laws.values()):
                        yield (case, laws), world, name


def _enumerator(mutant: BrokenEnumerator, edges: int) -> Kill:
    """Kill an enumerator by the count gate, or else by comparison with the brute-force one."""
    row = Kill(mutant=mutant.name, kind="enumerator", breaks=mutant.breaks)
    for level in range(1, edges + 1):
        level_maps = list(mutant.enumerate(level))
        counted = source_for("maps").cells(level)
        by_vertices = Counter(map_.vertex_count for map_ in level_maps)
        gate_agrees = all(by_vertices[n] == known for n, known in counted.items())
        wrong = _first_difference(level_maps, level)
        if wrong is not None:
            by = "brute-force enumerator" if gate_agrees else "count gate"
            return replace(row, killed_by=by, world=World(wrong, Directional(0)))
        if not gate_agrees:
            raise AssertionError(f"the count gate alone complains about {mutant.name}")
    return row


def _first_difference(maps: Iterable[CombinatorialMap], level: int) -> CombinatorialMap | None:
    """The smallest rooted map of the level that does not come exactly once."""
    found = Counter(_code(map_) for map_ in maps)
    expected = Counter(_code(map_) for map_ in rooted_maps_by_permutations(level))
    wrong = [code for code in found | expected if found[code] != expected[code]]
    return CombinatorialMap(*min(wrong)) if wrong else None


def _code(map_: CombinatorialMap) -> tuple[tuple[int, ...], tuple[int, ...]]:
    return rooted_code(map_.sigma, map_.alpha, 0)
