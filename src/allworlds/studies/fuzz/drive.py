"""A fuzzing run from its options to its report."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress

from typing_extensions import override

from allworlds.engines import (
    GivenWorlds,
    Identity,
    Listener,
    Portion,
    ReadyEngine,
    RunCounter,
    Sample,
    Scope,
    Silent,
    SweptLevel,
    Tally,
    TimeIsUp,
    Transport,
    gather,
    players_for,
    shards_of,
    subject_of,
    workers_for,
)
from allworlds.explorers import Subject
from allworlds.inputs import InputError, an_integer, answers, show
from allworlds.judging import Finding, Rules
from allworlds.maps import Extent
from allworlds.outcome import Completed, Ending
from allworlds.studies.check import (
    CheckReport,
    TallySweep,
    rules_known,
    subject_of_record,
)
from allworlds.studies.fuzz.fuzz_request import FuzzRequest
from allworlds.studies.fuzz.sample import batches
from allworlds.studies.fuzz.shrink import shrink

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
