"""Samples of worlds beyond the bound: request, shrinking, and the loop; of given worlds, too."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from typing import Annotated

from typing_extensions import override

from allworlds.engines.effort import AskedCluster, AskedDirectory, TimeIsUp
from allworlds.engines.engine_table import ReadyEngine, players_for
from allworlds.engines.job_records import Identity
from allworlds.engines.lanes import workers_for
from allworlds.engines.progress import Listener, Silent
from allworlds.engines.scope import GivenWorlds, Sample, Scope
from allworlds.engines.single import played_again, subject_of
from allworlds.engines.sweep import gather
from allworlds.engines.tally import RunCounter, Tally
from allworlds.engines.units import AskedShard, Portion, SweptLevel, Transport, shards_of
from allworlds.explorers.loading import Subject
from allworlds.inputs.checks import InputError, an_integer, integer_of, show
from allworlds.inputs.requests import SCOPE, Option, Request, answers
from allworlds.judging.findings.finding import Finding
from allworlds.judging.findings.rules import Rules
from allworlds.maps.canonical import Code, rooted_code
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.surgery import contracted, deleted, moved
from allworlds.outcome import Completed, Ending
from allworlds.studies.check.report import CheckReport
from allworlds.studies.check.requests import ManyRuns
from allworlds.studies.check.tally_sweep import TallySweep, rules_known, subject_of_record
from allworlds.studies.fuzz.sample import batches
from allworlds.world.own_condition import WhereOptions
from allworlds.world.world import World


class AskedSample(Request):
    """Options for drawing worlds: their sizes and their number."""

    edges: Annotated[int, Option(SCOPE, "M", "At most M edges.", parse=integer_of)]
    min_edges: Annotated[
        int,
        Option(
            SCOPE,
            "L",
            "At least L edges; choose more than an exhaustive check has tried.",
            parse=integer_of,
        ),
    ] = 1
    runs: Annotated[int, Option(SCOPE, "R", "The number of worlds.", parse=integer_of)]
    seed: Annotated[int, Option(SCOPE, "S", "Which sample.", parse=integer_of)] = 0


class MapsRequest(ManyRuns, WhereOptions):
    """Request for runs in given maps: an explorer, the class and a condition, rules and effort."""


class FuzzRequest(AskedDirectory, AskedCluster, AskedShard, MapsRequest, AskedSample):
    """Request of ``fuzz``: an explorer, the sample, rules and effort."""


Refute = Callable[[Sequence[GivenWorlds]], Finding | None]
"""The smallest finding among these worlds, or None."""

CHUNK = 50
"""The worlds that one worker tries at a time."""

WAVE = 8
"""The chunks that are tried before the next, larger worlds are begun."""


def shrink(finding: Finding, scope: Scope, refute: Refute) -> Iterator[Finding]:
    """Yield ever smaller refuting worlds, until no neighbour in the size order refutes.

    First an edge is deleted or contracted as long as that is possible; then, with as many
    edges, a dart may move and the start and the marker may turn, towards fewer vertices and
    the smaller code.  Every neighbour is rooted everywhere and lit from every place, and the
    smallest refuting one is taken, so the result depends on nothing but the finding.

    Cost: O(m^3) runs for each step with fewer edges.
    """
    smaller: Finding | None = finding
    while smaller:
        finding, map_ = smaller, smaller.world.map
        smaller = _smallest(refute, _picked(scope, finding, _fewer_edges(map_)))
        if smaller is None:
            smaller = _smallest(refute, _picked(scope, finding, [map_, *moved(map_)]))
        if smaller:
            yield smaller


def _smallest(refute: Refute, picked: Sequence[GivenWorlds]) -> Finding | None:
    """The smallest finding among worlds in ascending order; larger ones are not tried."""
    waves = (refute(picked[i : i + WAVE]) for i in range(0, len(picked), WAVE))
    return next((found for found in waves if found), None)


def _fewer_edges(map_: CombinatorialMap) -> Iterator[CombinatorialMap]:
    for dart, _ in map_.edges:
        for other in (deleted(map_, dart), contracted(map_, dart)):
            if other is not None:
                yield other


def _picked(scope: Scope, finding: Finding, maps: Iterable[CombinatorialMap]) -> list[GivenWorlds]:
    """Rootings and places of these maps that are smaller than the finding, ascending."""
    kind, size = scope.rules.kind, finding.key[:4]
    ordered = []
    for key in rootings(maps, scope.extent):
        if key > size[:3]:
            break
        map_ = CombinatorialMap.trusted(*key[2])
        for place, lighthouse in enumerate(kind.places(map_, 0)):
            if (*key, place) < size:
                ordered.append((World(map_, lighthouse), place))
    return in_chunks(ordered)


def rootings(maps: Iterable[CombinatorialMap], extent: Extent) -> list[tuple[int, int, Code]]:
    """Rootings of these maps of the class, each once; ordered by edges, vertices and code.

    A condition of the extent must be true of them; its bounds do not matter.
    """
    return sorted(
        {
            (map_.edge_count, map_.vertex_count, rooted_code(map_.sigma, map_.alpha, start))
            for map_ in maps
            if extent.map_class.includes(map_) and extent.admits(map_)
            for start in map_.darts
        }
    )


def in_chunks(worlds: Sequence[tuple[World, int]]) -> list[GivenWorlds]:
    """Worlds with the numbers of their places, in pieces that one worker tries at a time."""
    return [GivenWorlds(tuple(worlds[i : i + CHUNK])) for i in range(0, len(worlds), CHUNK)]


MANY_EDGES = 10_000_000
"""The total number of edges above which a notice says that the run takes long."""


@answers(FuzzRequest)
def fuzz(request: FuzzRequest) -> CheckReport:
    """Run an explorer in random worlds of up to ``edges`` edges; shrink what refutes it.

    The report is a sample's: at best ``not-refuted``, never complete.  The sample depends on
    the class, ``where``, ``edges``, ``min_edges``, ``runs`` and ``seed`` alone, and the finding is
    the smallest that the shrinker reaches from the smallest refuting world of the sample; that may
    have fewer than ``min_edges`` edges.  Shrinking ends with the time limit.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    subject = subject_of(request.explore, request.limits)
    scope = scope_of(request, request.rules(subject))
    return FuzzSweep(request, scope, subject).answer(request.run)


def scope_of(request: FuzzRequest, rules: Rules) -> Scope:
    """The scope of a request: the drawn worlds and the rules.

    Raises:
        InputError: for numbers out of range.
    """
    sample = Sample(request.runs, request.seed, request.min_edges, request.shard)
    edges = an_integer("edges", request.edges)
    if edges < 1:
        raise InputError(f"edges = {show(edges)} is not positive")
    if sample.min_edges > edges:
        raise InputError(f"min-edges = {show(sample.min_edges)} is more than edges = {edges}")
    return Scope(Extent(request.map_class, edges, where=request.where), rules, coverage=sample)


class FuzzSweep(TallySweep[CheckReport]):
    """The sweep of a sample. It is one level, of which every finished part is reported.

    Args:
        request: what was asked for.
        scope: the worlds and the rules.
        subject: the explorer.
        shards: the number of parts that are joined, if they were done apart.
    """

    verb, asked = "fuzz", FuzzRequest

    def __init__(
        self, request: FuzzRequest, scope: Scope, subject: Subject, shards: int = 1
    ) -> None:
        super().__init__(request, scope, subject)
        self._shards = max(shards, shards_of(self.portion))
        self._tally = self.empty()

    @override
    @classmethod
    def known(cls, identity: Identity, portion: Portion, listener: Listener) -> FuzzSweep:
        request = cls.asked_then(identity, portion, listener)
        rules = rules_known(request, identity.parameters)
        subject = subject_of_record(identity.explorer)
        return cls(request, scope_of(request, rules), subject, identity.shards)

    @override
    def levels(self) -> Iterable[SweptLevel]:
        sample, edges = self.scope.coverage, self.request.edges
        assert isinstance(sample, Sample)
        yield SweptLevel(edges, sample.runs, batches(sample, self._shards))

    @override
    def begin(self) -> None:
        edges, runs = self.request.edges, self.request.runs
        if edges * runs > MANY_EDGES:
            self.listener.notice(
                f"{runs} worlds with up to {edges} edges take long; an interrupt ends it with what "
                "is finished"
            )

    @override
    def ready(self) -> ReadyEngine:
        return ReadyEngine(players_for(self.job), RunCounter(self.scope, self.job.keep))

    @override
    def finish(self, level: SweptLevel, total: Tally) -> None:
        self._tally = total

    leave = finish

    @override
    def conclude(self, ending: Ending) -> Ending:
        """Shrink the findings of the whole sample, and confirm the result."""
        settled = self.confirmation
        if isinstance(ending, Completed):
            self._tally.findings = [
                settled.replaced("shrunk", found, self._shrunk) for found in self._tally.findings
            ]
        self._tally.findings = settled.confirmed(self._tally.findings)
        if self._tally.findings and settled.is_late:
            raise TimeIsUp  # it may have been given up
        return ending

    def _shrunk(self, found: Finding) -> Finding:
        job = self.job
        with workers_for(job.subject, job.limits, self.deadline) as workers:
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
        )


def smallest_from(finding: Finding, workers: Transport[RunCounter], scope: Scope) -> Finding:
    """The smallest finding that the shrinker reaches from this one, or has when the time is up."""

    def refute(given: Sequence[GivenWorlds]) -> Finding | None:
        found = Tally(keep=1)
        gather(workers, RunCounter(scope, found.keep), given, found, Silent())
        return found.findings[0] if found.findings else None

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
    subject = subject_of(request.explore, limits)
    rules = request.rules(subject)
    met = [*maps]
    most = max((map_.edge_count for map_ in met), default=1)
    scope = Scope(Extent(request.map_class, most, where=request.where), rules)
    given = [*_rooted(met, scope)]
    if not given:
        return None
    tally = Tally(keep=1)
    with workers_for(subject, limits, limits.deadline()) as workers:
        gather(workers, RunCounter(scope, tally.keep), in_chunks(given), tally, Silent())
        for found in tally.findings:
            smallest = smallest_from(found, workers, scope)
            return played_again(smallest, subject, limits)
    return None


def _rooted(maps: Iterable[CombinatorialMap], scope: Scope) -> Iterator[tuple[World, int]]:
    """Rooted maps with every place, each once, smallest first."""
    for *_, code in rootings(maps, scope.extent):
        map_ = CombinatorialMap.trusted(*code)
        for place, lighthouse in enumerate(scope.rules.kind.places(map_, 0)):
            yield World(map_, lighthouse), place
