"""``fuzz``: worlds far beyond the exhaustive bound, and the way back to small ones."""

from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import count, islice, takewhile
from random import Random
from typing import Annotated, Any, TypeAlias

from msgspec import Struct, json
from typing_extensions import override

from allworlds.documents.document import Text, about, replace
from allworlds.engines import batch, lanes, single, sweep
from allworlds.engines.batch import Due
from allworlds.engines.engine_table import ReadyEngine, players_for
from allworlds.engines.job_records import Identity
from allworlds.engines.judge import PythonJudge
from allworlds.engines.limits import Limits, TimeIsUp, deadline_after
from allworlds.engines.listeners import NOBODY, Listener
from allworlds.engines.players import Lost, Setup, answered, started
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import (
    GivenWorlds,
    NumberedRun,
    Sample,
    Scope,
    Shard,
    ShardOptions,
    SweptLevel,
    Transport,
    UnitOfRuns,
)
from allworlds.explorers import loading, sources
from allworlds.inputs.checks import InputError, integer_of, show
from allworlds.inputs.requests import RARE_SCOPE, SCOPE, Converted, Option, Request, answers
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import LAWS
from allworlds.judging.rules import Rules, law_names
from allworlds.maps import build
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import Code, CombinatorialMap, rooted_code
from allworlds.maps.enumeration import rooted_maps
from allworlds.maps.mixture import (
    HISTORIES,
    PARTS,
    default_mix,
    generator,
    mix_named,
    mutated,
    rerooted,
)
from allworlds.notations.given import Placed
from allworlds.outcome import Completed, Ending
from allworlds.protocol.code_lines import ONCE, Place
from allworlds.studies.check import hints
from allworlds.studies.check.covered import features
from allworlds.studies.check.report import CheckReport, ManyWorlds
from allworlds.studies.check.tally_sweep import (
    CorpusOptions,
    TallySweep,
    rules_known,
    subject_of_record,
)
from allworlds.studies.options import ClusterOptions, RunDirectoryOptions
from allworlds.world import selection, world
from allworlds.world.lighthouses.base import Lighthouse


class SampleOptions(Request):
    """Options for drawing worlds: their sizes and their number."""

    edges: Annotated[int, Option(SCOPE, "M", "At most M edges.", parse=integer_of)]
    mix: Annotated[
        Converted[Iterable[str] | None, tuple[str, ...] | None],
        Option(
            RARE_SCOPE,
            "NAMES",
            f"Draw of these alone, with commas: {', '.join(PARTS)} [default: those of the class].",
            parse=law_names,
            document_type=Annotated[
                tuple[Text, ...], about("the distributions that were drawn of, in turn")
            ],
        ),
    ] = Converted(mix_named, None)
    min_edges: Annotated[
        int,
        Option(
            SCOPE,
            "L",
            "At least L edges; choose more than an exhaustive check has tried.",
            parse=integer_of,
        ),
    ] = 1
    runs: Annotated[int, Option(SCOPE, "R", "The number of worlds.", parse=integer_of)] = 1024
    seed: Annotated[int, Option(SCOPE, "S", "Which sample.", parse=integer_of)] = 0


class MapsRequest(ManyWorlds, sources.ExplorerOptions, selection.WhereOptions):
    """Request for runs in given maps: an explorer, the class and a condition, rules and effort."""


class FuzzRequest(
    CorpusOptions, RunDirectoryOptions, ClusterOptions, ShardOptions, MapsRequest, SampleOptions
):
    """Request of ``fuzz``: an explorer, the sample, rules and effort."""


@answers(FuzzRequest)
def fuzz(request: FuzzRequest) -> CheckReport:
    """Run an explorer in random worlds of up to ``edges`` edges; shrink what refutes it.

    The report is a sample's: at best ``not-refuted``, never complete.  The sample depends on
    the class, ``where``, ``edges``, ``min_edges``, ``mix``, ``runs`` and ``seed`` alone.  It ends
    after the first 16, 64, 256, ... runs of which one refutes.  The finding is the smallest that
    the shrinker reaches from the smallest refuting world of these; that may have fewer than
    ``min_edges`` edges.  Shrinking ends with the time limit.  Of an explorer in Python worlds are
    bred, too: see :func:`bred`.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    subject = single.subject_of(request.explore, request.limits)
    scope = scope_of(request, request.rules(subject))
    return FuzzSweep(request, scope, subject).answer(request.run)


def scope_of(request: FuzzRequest, rules: Rules) -> Scope:
    """The scope of a request: the drawn worlds and the rules.

    Raises:
        InputError: for numbers out of range.
    """
    extent = Extent(request.map_class, request.edges, where=request.where)
    mix = request.mix or default_mix(extent)
    sample = Sample(request.runs, request.seed, request.min_edges, request.shard, mix)
    if sample.min_edges > request.edges:
        least, most = show(sample.min_edges), show(request.edges)
        raise InputError(f"min-edges = {least} is more than edges = {most}")
    return Scope(extent, rules, coverage=sample)


class SampleCounter(RunCounter, frozen=True, kw_only=True):
    """The runs of a sample, counted with the features of its worlds; and of bred worlds.

    Attributes:
        subject, limits: of the explorer, for those who are bred.
    """

    subject: loading.Subject
    limits: Limits

    @override
    def runs(self, unit: UnitOfRuns, start: int = 0) -> Iterator[NumberedRun]:
        if isinstance(unit, Bred):
            return islice(bred(unit, self.scope, self.subject, self.limits), start, None)
        return super().runs(unit, start)

    @override
    def count_run(self, run: NumberedRun, tally: Tally) -> world.World | None:
        tally.covered.update(features(run.map))
        return super().count_run(run, tally)


class FuzzSweep(TallySweep[CheckReport]):
    """The sweep of a sample.

    Its levels are waves of draws, each four times as large as all before, and between them worlds
    bred from the draws.  Every finished part is reported; a level with a finding is the last one.

    Args:
        request: what was asked for.
        scope: the worlds and the rules.
        subject: the explorer.
    """

    verb, asked = "fuzz", FuzzRequest

    def __init__(self, request: FuzzRequest, scope: Scope, subject: loading.Subject) -> None:
        super().__init__(request, scope, subject)
        self._tally, self._bred = self.empty(), 0

    @override
    @classmethod
    def known(cls, identity: Identity, portion: Shard, listener: Listener) -> "FuzzSweep":
        request = cls.asked_then(identity, portion, listener)
        rules = rules_known(request, identity.parameters)
        subject = subject_of_record(identity.explorer)
        return cls(request, scope_of(request, rules), subject)

    @override
    def levels(self) -> Iterable[SweptLevel]:
        sample, edges = self.scope.coverage, self.request.edges
        assert isinstance(sample, Sample)
        subject, blocks = self.job.subject, 0
        for begin, end in waves(sample.runs):
            yield SweptLevel(edges, end - begin, batches(sample, begin, end))
            until = end // BLOCK
            if until > blocks and is_bred_for(subject):
                mine = [*bred_of(sample, range(blocks * BLOCK, until * BLOCK, BLOCK))]
                yield SweptLevel(edges, 0, mine, of=len(mine) * BRED)
                blocks = until

    @override
    def begin(self) -> Ending | None:
        """Try past findings."""
        return self.retry_past(self._tally)

    @override
    def ready(self) -> ReadyEngine:
        job = self.job
        counter = SampleCounter(self.scope, job.keep, subject=job.subject, limits=job.limits)
        return ReadyEngine(players_for(job), counter)

    @override
    def finish(self, level: SweptLevel, total: Tally) -> Ending | None:
        self.leave(level, total)
        self._bred += level.of or 0
        return Completed() if self._tally.findings else None

    @override
    def leave(self, level: SweptLevel, total: Tally) -> None:
        if level.of is not None:  # bred worlds do not count
            total = Tally(total.keep, findings=total.findings, remarks=total.remarks)
        self._tally.add(total)

    @override
    def conclude(self, ending: Ending) -> None:
        """Shrink the findings of the whole sample, and confirm the result."""
        settled = self.confirmation
        if isinstance(ending, Completed):
            self._tally.findings = [
                settled.replaced("shrunk", found, self._shrunk) for found in self._tally.findings
            ]
        past = self.corpus is not None and any(map(self.corpus.holds, self._tally.findings))
        if not past:
            self._tally.findings = settled.confirmed(self._tally.findings)
            self.keep_new(self._tally)
        if self._tally.findings and settled.is_late:
            raise TimeIsUp  # it may have been given up

    def _shrunk(self, found: Finding) -> Finding:
        job = self.job
        with lanes.workers_for(job.subject, job.limits, self.deadline) as workers:
            return smallest_from(found, workers, self.scope)

    @override
    def report(self, ending: Ending) -> CheckReport:
        return CheckReport(
            **self.ended(ending, self.scope.extent),
            explorer=self.job.subject.name,
            engine="python",
            asked=self.scope,
            tally=self._tally,
            levels=(),
            past=self.corpus,
            offspring=self._bred,
            seconds=tuple(self.seconds),
        )


# ---------------------------------------------------------------- the way back

Refute: TypeAlias = Callable[[Sequence[GivenWorlds]], Finding | None]
"""The smallest finding among these worlds, or None."""

CHUNK = 50
"""The worlds that one worker tries at a time."""

WAVE = 8
"""The chunks that are tried before the next, larger worlds are begun."""


def shrink(finding: Finding, scope: Scope, refute: Refute) -> Iterator[Finding]:
    """Yield ever smaller refuting worlds, until no neighbour that is tried refutes.

    First pieces of the map are taken away, half of it, a quarter and so on, the start kept.
    Then an edge is deleted or contracted as long as that is possible; then, with as many
    edges, a dart may move and the start and the marker may turn, towards fewer vertices and
    the smaller code.  Every neighbour is rooted everywhere and lit from every place, and the
    smallest refuting one is taken, so the result depends on nothing but the finding.  At last all
    worlds with few edges are tried.

    Cost: O(m^3) runs for each step of small worlds, but at most ``TRIED``; large ones are left as
    they are when no piece of them can go.
    """
    for less in _with_pieces_less(finding, scope, refute):
        yield (finding := less)
    smaller: Finding | None = finding
    while smaller and smaller.world.map.edge_count <= FINE:
        finding, map_ = smaller, smaller.world.map
        smaller = _smallest(refute, _smaller(scope, finding, _fewer_edges(map_)))
        if smaller is None:
            smaller = _smallest(refute, _smaller(scope, finding, [map_, *build.moved(map_)]))
        if smaller:
            yield smaller
    extent, most = scope.extent, finding.world.map.edge_count
    for edges in range(1, min(EVERY, most) + 1):
        maps = rooted_maps(edges, extent.map_class, where=extent.where)
        smallest = _smallest(refute, _smaller(scope, finding, maps))
        if smallest:
            yield smallest
            return


EVERY = 4
"""The number of edges up to which every world is tried at last."""

FINE, TRIED = 16, 4000
"""The number of edges above which not every neighbour is tried, and of neighbours in a step."""

AS_FAR, LEAST = 2, 100
"""The walk after which a smaller world is passed over: so many times that of the finding, and so
many traversals more."""

FEW = 4
"""The worlds with a piece less that one worker tries at a time, and twice as many in a wave."""


def _with_pieces_less(finding: Finding, scope: Scope, refute: Refute) -> Iterator[Finding]:
    """Yield ever smaller refuting worlds, of which a piece was deleted or contracted at a time.

    A piece are edges that follow each other breadth-first from the start; the farthest come first.
    As long as one of them can go, others of that size are tried, and then those of half the size.
    The place of the lighthouse keeps its number, if there are so many.

    Cost: O(m) runs for each step, but about O(m log m) in all if few edges are needed.
    """
    piece = finding.world.map.edge_count // 2
    while piece:
        worlds = list(_less_by(piece, finding, scope))
        few = [GivenWorlds(tuple(worlds[i : i + FEW])) for i in range(0, len(worlds), FEW)]
        found = _smallest(refute, few, at_once=2)
        if found:
            finding = found
            yield finding
        piece = min(piece if found else piece // 2, finding.world.map.edge_count // 2)


def _less_by(piece: int, finding: Finding, scope: Scope) -> Iterator[tuple[world.World, int]]:
    """The finding's world without so many edges, deleted or contracted, and the place."""
    map_, extent = finding.world.map, scope.extent
    for end in range(map_.edge_count, 0, -piece):
        gone = {d for edge in map_.edges[max(0, end - piece) : end] for d in edge}
        deleted, contracted = build.without(map_, gone), build.without(map_.dual(), gone)
        for other in (deleted, contracted and contracted.dual()):
            if other and extent.map_class.includes(other) and extent.admits(other):
                places = [*scope.rules.kind.places(other, 0)]
                for place in {finding.place, finding.place % max(1, len(places))}:
                    if place < len(places):
                        yield world.World(other, places[place]), place


def _smallest(refute: Refute, chunks: Sequence[GivenWorlds], at_once: int = WAVE) -> Finding | None:
    """The smallest finding of the first wave that has one; of later ones none is tried."""
    waves = (refute(chunks[i : i + at_once]) for i in range(0, len(chunks), at_once))
    return next((found for found in waves if found), None)


def _fewer_edges(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    for dart, _ in map_.edges:
        for other in (build.deleted(map_, dart), build.contracted(map_, dart)):
            if other is not None:
                yield other


def _smaller(scope: Scope, finding: Finding, maps: Iterable[CombinatorialMap]) -> list[GivenWorlds]:
    """The first rootings and places of these maps that are smaller than the finding, ascending."""
    size = finding.key[:4]
    placed = takewhile(lambda each: each[0] < size, _placed(maps, scope))
    return _in_chunks([each for _, each in islice(placed, TRIED)])


def _placed(
    maps: Iterable[CombinatorialMap], scope: Scope
) -> Iterator[tuple[tuple[int, int, Code, int], tuple[world.World, int]]]:
    """Rootings of these maps, each once and with every place; ascending by what is beside them.

    That is: edges, vertices, code, place.  The maps are of the class of the extent, and its
    condition is true of them; its bounds do not matter.
    """
    extent = scope.extent
    rootings = {
        (map_.edge_count, map_.vertex_count, rooted_code(map_.sigma, map_.alpha, start))
        for map_ in maps
        if extent.map_class.includes(map_) and extent.admits(map_)
        for start in map_.darts
    }
    for key in sorted(rootings):
        map_ = CombinatorialMap.trusted(*key[2])
        for place, lighthouse in enumerate(scope.rules.kind.places(map_, 0)):
            yield (*key, place), (world.World(map_, lighthouse), place)


def _in_chunks(worlds: Sequence[tuple[world.World, int]]) -> list[GivenWorlds]:
    """Worlds with the numbers of their places, in pieces that one worker tries at a time."""
    return [GivenWorlds(tuple(worlds[i : i + CHUNK])) for i in range(0, len(worlds), CHUNK)]


def smallest_from(finding: Finding, workers: Transport, scope: Scope) -> Finding:
    """The smallest finding that the shrinker reaches from this one, or has when the time is up.

    A wrong explorer often walks until its budget is used up.  Unless it is the budget that it
    breaks, worlds are passed over in which it walks more than so many times as far as in the
    finding that is made smaller.
    """
    rules = scope.rules

    def refute(given: Sequence[GivenWorlds]) -> Finding | None:
        tried, found = scope, Tally(keep=len(LAWS))
        if finding.law != "budget":
            most = min(rules.budget(finding.world.map), AS_FAR * finding.transcript.cost + LEAST)
            tried = replace(scope, rules=replace(rules, step_budget=most))
        sweep.gather(workers, RunCounter(tried, found.keep), given, found, NOBODY)
        for each in found.findings:
            ends = each.law != "budget" and each.transcript.cost <= rules.budget(each.world.map)
            if ends or tried is scope:
                return replace(each, under=rules, options=rules.recorded)
        return None

    with suppress(TimeIsUp):
        for smaller in shrink(finding, scope, refute):
            finding = smaller
    return finding


def refuted_in(maps: Iterable[CombinatorialMap], request: MapsRequest) -> Finding | None:
    """The smallest finding that the shrinker reaches from these maps; None where no law is broken.

    The explorer starts at every dart of each map, with every place of the lighthouse.  Maps
    that are not of the class, or of which the condition is not true, are left out.

    Args:
        maps: of any size.
        request: for an explorer, the class, a condition, rules and limits.

    Raises:
        InputError: naming the offending option and what would be legal.
        TimeIsUp: at the time limit.
        Unsettled: if what happened to the explorer cannot be told.

    Cost: O(m) runs for each map with m edges.
    """
    limits = request.limits
    subject = single.subject_of(request.explore, limits)
    rules = request.rules(subject)
    tried = [*maps]
    most = max((map_.edge_count for map_ in tried), default=1)
    scope = Scope(Extent(request.map_class, most, where=request.where), rules)
    given = [world for _, world in _placed(tried, scope)]
    if not given:
        return None
    tally = Tally(keep=1)
    with lanes.workers_for(subject, limits, deadline_after(limits.time_limit)) as workers:
        sweep.gather(workers, RunCounter(scope, tally.keep), _in_chunks(given), tally, NOBODY)
        for found in tally.findings:
            smallest = smallest_from(found, workers, scope)
            return hints.located(single.played_again(smallest, subject, limits), subject, limits)
    return None


# ---------------------------------------------------------------- the sample

BATCH = 8
"""The runs that one worker does at a time."""

EARLY = 16
"""The runs of the first wave.  A wrong explorer in a world with 50 edges may go on until its budget
of some 500,000 traversals: 64 draws with 40 to 60 edges took more than six minutes of a processor.
"""

PATIENCE = 100
"""The number of maps of one part that are rejected before histories are used."""

LONGEST = 2000
"""The number of maps that are rejected before a condition is refused."""


def waves(runs: int) -> Iterator[tuple[int, int]]:
    """The first run of each wave, and the first of the next: 0, 16, 64, 256, ..."""
    begin = 0
    while begin < runs:
        end = min(max(EARLY, 4 * begin), runs)
        yield begin, end
        begin = end


def batches(sample: Sample, begin: int = 0, end: int | None = None) -> "Iterator[Batch]":
    """These runs of the sample in pieces, or the part of its shard: every so manieth piece.

    They do not depend on the number of workers or shards.

    Args:
        sample: the whole, or the part of a shard.
        begin: the first run, the first one of a piece.
        end: the run after the last one; by default all.
    """
    end, portion = sample.runs if end is None else end, sample.portion
    for first in range(begin, end, BATCH):
        if first // BATCH % portion.count == portion.index:
            last = min(first + BATCH, end)
            yield Batch(sample.seed, first, last, sample.mix, sample.min_edges)


class Batch(Struct, frozen=True):
    """The runs ``first .. last - 1`` of the sample with that seed and least number of edges."""

    seed: int
    first: int
    last: int
    mix: tuple[str, ...]
    min_edges: int = 1

    @property
    def key(self) -> str:
        """Key of the batch in a run directory: ``SEED/FIRST``."""
        return f"{self.seed}/{self.first}"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """One world a run: a random map with a random place of the lighthouse.

        The parts of the mixture come in turn, and each has a sequence of its own: it is the same
        whatever else there is in the mixture.  A map that is not of the extent, or is too small, is
        drawn again; a part that brings none for long gives way to random histories of the class.
        """
        mix = self.mix or default_mix(extent)
        for run in range(self.first, self.last):
            turn, at = divmod(run, len(mix))
            number = turn * mix.count(mix[at]) + mix[:at].count(mix[at])
            random = Random(f"{mix[at]}/{self.seed}/{number}")  # noqa: S311  # reproducible
            map_ = self._drawn(extent, mix[at], random)
            places = list(enumerate(kind.places(map_, 0)))
            yield map_, [random.choice(places)] if places else []

    def _drawn(self, extent: Extent, part: str, random: Random) -> CombinatorialMap:
        """A map of the extent; by a history where the part brings none for long.

        Raises:
            InputError: if histories bring none for long that the condition admits.
        """
        generators = generator(part, extent), generator(HISTORIES, extent)
        size = random.randint(self.min_edges, extent.levels[-1])
        for tries in count():
            map_ = rerooted(generators[tries >= PATIENCE](size, random), random)
            large = map_.edge_count >= self.min_edges
            if large and extent.map_class.includes(map_) and extent.admits(map_):
                return map_
            if extent.where is not None:
                if tries == LONGEST:
                    break
                size = random.randint(self.min_edges, extent.levels[-1])
        assert extent.where is not None
        raise InputError(
            f"where {show(extent.where.name)}: {tries + 1} maps of the class {extent.map_class} "
            f"with {self.min_edges} to {extent.levels[-1]} edges were drawn, and it is true of "
            "none; legal is one that is true of more of them"
        )


# ---------------------------------------------------------------- bred worlds

BLOCK, FIRST, BRED = 256, 64, 192
"""The draws of a block, the first ones of which others are bred, and the number of these."""

GENERATION = 16
"""The worlds that are bred before their parents are chosen anew."""

RAREST, PARENTS = 4, 8
"""The number of lines of whose last worlds parents are drawn, and of these worlds."""

LONG = 20_000
"""The traversals after which a run is no longer traced."""

MISSES = 20
"""The mutants of a world that may all be outside the class."""


class Bred(Struct, frozen=True):
    """Worlds that are bred from some draws."""

    drawn: Batch

    @property
    def key(self) -> str:
        """Key in a run directory: ``SEED/FIRST/bred``."""
        return f"{self.drawn.key}/bred"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """The draws."""
        return self.drawn.placed(extent, kind)


def bred_of(sample: Sample, begins: Iterable[int]) -> Iterator[Bred]:
    """The worlds bred from the blocks that begin there, of the part of its shard."""
    for first in begins:
        if first // BLOCK % sample.portion.count == sample.portion.index:
            yield Bred(Batch(sample.seed, first, first + FIRST, sample.mix, sample.min_edges))


def is_bred_for(subject: loading.Subject) -> bool:
    """Whether worlds are bred for an explorer: a user's, whose lines can be traced."""
    return subject.from_user and not (
        loading.is_program(subject.name) or loading.is_library(subject.name)
    )


def bred(
    unit: Bred, scope: Scope, subject: loading.Subject, limits: Limits
) -> Iterator[NumberedRun]:
    """Yield the bred worlds that seem to refute, towards lines that few worlds run.

    The first draws of the block are played and their lines traced; then, a generation at a time,
    mutants of worlds that ran one of the rarest lines.  The worlds depend on the explorer and on
    these draws alone.  A player that is lost ends it.

    Only lines are a target, since only they help.  Measured with up to 60 edges: 48 times a slip
    behind four nested conditions was sought; 256 draws found 4, 64 draws and 192 bred worlds 14.
    With up to 12 edges one such slip is found from 7 of 8 seeds, by 448 draws from one.  Towards a
    high cost, or long agreement with a wrong hypothesis, breeding finds less than as many draws:
    belief after 24 steps, depth first, from 2 and 1 of 6 seeds, draws from 4; a cost above 8,000
    from 4 and 3, draws from 5; at up to four times the processor time.

    Cost: 256 traced runs, each some three times a plain one.
    """
    rules, extent = replace(scope.rules, step_budget=LONG), scope.extent
    number, pool = 0, _Pool(unit, extent, rules.kind)
    judge = PythonJudge(RunCounter(Scope(extent, rules), keep=1), subject.name)
    player = started(Setup(subject, limits), batch.FIRST)
    try:
        for generation in range(1 + BRED // GENERATION):
            placed = pool.bred() if generation else unit.placed(extent, rules.kind)
            due = [
                Due(0, place, world.World(map_, lighthouse, 0))
                for map_, places in placed
                for place, lighthouse in places
            ]
            message = judge.worlds_message(due) | {"lines": ONCE, "runs": len(due) + 1}
            *logs, traced = answered(player, message)
            told = json.decode(traced, type=list[tuple[Any, list[Place]]]) if due else []
            for run, log, (_, lines) in zip(due, logs, told, strict=True):
                pool.add(run.world.map, lines)
                if generation and judge.judged(run, log).outcome.violation:
                    yield NumberedRun(
                        number, run.world.map, run.place, run.world.lighthouse, first=True
                    )
                    number += 1
            if not pool.lately:
                return
    except Lost:
        return
    finally:
        player.close()


class _Pool:
    """The worlds from which others are bred.

    Attributes:
        lately: of each line the last worlds that ran it.
    """

    def __init__(self, unit: Bred, extent: Extent, kind: type[Lighthouse]) -> None:
        self.lately: dict[Place, deque[CombinatorialMap]] = {}
        self._often = Counter[Place]()
        self._least, self._extent, self._kind = unit.drawn.min_edges, extent, kind
        self._random = Random(f"bred/{unit.key}")  # noqa: S311  # reproducible

    def add(self, map_: CombinatorialMap, lines: Iterable[Place]) -> None:
        """Take in a world, which ran these lines."""
        for line in lines:
            self._often[line] += 1
            self.lately.setdefault(line, deque(maxlen=PARENTS)).append(map_)

    def bred(self) -> Iterator[Placed]:
        """A generation, each with a random place of the lighthouse."""
        rarest = sorted(self.lately, key=lambda line: (self._often[line], line))[:RAREST]
        for _ in range(GENERATION):
            parent = self._random.choice(self.lately[self._random.choice(rarest)])
            child = self._child(parent)
            places = list(enumerate(self._kind.places(child, 0)))
            yield child, [self._random.choice(places)] if places else []

    def _child(self, parent: CombinatorialMap) -> CombinatorialMap:
        """A mutant of the extent; the parent where there is none for long."""
        for _ in range(MISSES):
            child = mutated(parent, self._extent.levels[-1], self._random)
            if child.edge_count >= self._least and self._extent.include(child):
                return child
        return parent
