"""Level by level: the exhaustive check from its options to its report."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace

from allworlds.engines import (
    ENDED,
    LOST,
    UNMERGEABLE,
    ClusterLost,
    EngineKind,
    EnginesDisagree,
    Identity,
    Job,
    Listener,
    Once,
    ReadyEngine,
    Records,
    Scope,
    Silent,
    Tally,
    TimeIsUp,
    Unsettled,
    confirmed,
    engine_for,
    gather,
    level_size,
    nondeterministic,
    records_in,
    shards_of,
    subject_of,
    tell_of_size,
    why_not_compiled,
)
from allworlds.inputs import InputError, a_path, answers, show
from allworlds.judging import Finding
from allworlds.outcome import Verdict
from allworlds.studies.check.ending import Completed, Disagreed, Ending, Interrupted, Stopped
from allworlds.studies.check.gate import GateCell, count_gate, missing_witnesses
from allworlds.studies.check.known_findings import UserCorpus
from allworlds.studies.check.report import CheckReport
from allworlds.studies.check.requests import CheckRequest, EstimateRequest
from allworlds.studies.check.run_identity import identity_of, job_of, settled_once, shelf_for
from allworlds.studies.check.time_estimate import (
    LONG,
    Guess,
    TimeEstimate,
    estimated,
    extrapolated,
    is_worth_a_guess,
    one_larger,
)
from allworlds.words import duration


@answers(CheckRequest)
def check(request: CheckRequest) -> CheckReport:
    """Run an explorer on every start and every marker orientation of every map in a class.

    An explorer that cannot be imported by its name runs in this process, where its
    KeyboardInterrupt cannot be told from the user's: it interrupts the check.  In a worker it
    is a crash.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    run, corpus, listener = request.run, request.corpus, request.listener
    job, chosen = _job(request, keep=request.max_findings)
    directory = None if corpus is None else UserCorpus(a_path("corpus", corpus))
    if run is not None and corpus is not None:
        raise InputError(
            f"corpus {show(str(corpus))} cannot be given with run {show(str(run))}: what is in the "
            "one would change what the other keeps; give one of them"
        )
    if run is None and not job.scope.whole:
        listener.notice(UNMERGEABLE)
    with records_in(
        run, lambda: identity_of(request, job, chosen.name), listener.notice
    ) as records:
        return _Check(job, chosen, listener, directory, records).run(_say_how_long)


@answers(EstimateRequest)
def estimate(request: EstimateRequest) -> TimeEstimate:
    """How long :func:`check` will take with these options, from a sample of some seconds.

    And with more edges: one more is tried as well, by the engine that would do it, and for the
    next the time goes on growing as it did.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    heard = replace(request, listener=Once(request.listener))
    job, chosen = _job(heard)
    guess, larger = estimated(job, chosen), tuple[Guess, ...]()
    if guess.rate and (extent := one_larger(job)):
        # What an engine cannot do ends the table.
        with suppress(InputError):
            job, chosen = _job(replace(heard, edges=extent.edges))
            more = estimated(job, chosen)
            larger = (more, *extrapolated(job, (guess, more)))
    return TimeEstimate(explorer=job.subject.name, larger=larger, **guess.to_json())


def _job(request: EstimateRequest, keep: int = 1) -> tuple[Job, EngineKind]:
    """What is to be done, and by which engine."""
    limits, notice = request.limits, request.listener.notice
    subject = subject_of(request.explore, limits)
    scope = Scope(request.extent, request.rules(subject), request.schedules, request.shard)
    if scope.schedules == "all" and not subject.takes_choices:
        raise InputError(f"schedules 'all' needs an explorer with choices; {subject.name} has none")
    if request.engine == "auto" and (why := why_not_compiled(scope, subject)):
        notice(why)
    job = Job(scope, subject, limits, keep, limits.deadline(), notice, request.dask)
    return job, engine_for(request.engine, scope, subject, limits.memory)


def merged_check(identity: Identity, records: Records, listener: Listener) -> CheckReport:
    """The report of a check that others have done, made from what they have kept.

    It is the check itself, with nothing left to do: every count is added up and compared anew.

    Raises:
        Gap: if something is missing.
    """
    job, engine = job_of(identity, listener)
    return _Check(job, engine, listener, None, records).run()


def _say_how_long(job: Job, engine: EngineKind, listener: Listener) -> None:
    """Say it beforehand, if it is long and somebody listens."""
    if not isinstance(listener, Silent) and is_worth_a_guess(job, engine):
        seconds = estimated(job, engine).seconds
        if seconds is not None and seconds > LONG:
            listener.notice(f"this will take about {duration(seconds)}: a guess from a sample")


class _Check:
    """One check on its way."""

    def __init__(
        self,
        job: Job,
        engine: EngineKind,
        listener: Listener,
        corpus: UserCorpus | None,
        records: Records,
    ) -> None:
        self._job, self._engine, self._records = job, engine, records
        self._scope, self._subject = job.scope, job.subject
        self._listener, self._corpus = listener, corpus
        self._tally = Tally(job.keep)
        self._levels: list[int] = []
        self._gate: list[GateCell] = []

    def run(
        self, beforehand: Callable[[Job, EngineKind, Listener], None] = lambda *_: None
    ) -> CheckReport:
        try:
            beforehand(self._job, self._engine, self._listener)
            ending = self._tried()
        except KeyboardInterrupt:
            ending = Interrupted()
        report = self._report(ending)
        self._records.note("ended", ENDED if report.ended else ending.reason)
        if report.runs and not self._tally.traversals and report.verdict is Verdict.HOLDS:
            self._listener.notice("every run holds, and none of them has walked an edge")
        return report

    def _report(self, ending: Ending) -> CheckReport:
        return CheckReport(
            explorer=self._subject.name,
            engine=self._engine.name,
            asked=self._scope,
            tally=self._tally,
            levels=tuple(self._levels),
            ending=ending,
            cells=tuple(self._gate),
            past=self._corpus,
            symmetry=self._engine.symmetry(self._scope, self._subject),
        )

    def _tried(self) -> Ending:
        """Past findings first; then the scope, and what it shows is confirmed and kept."""
        job, corpus = self._job, self._corpus
        if corpus is not None:
            self._tally.findings = corpus.retry(job.subject, job.limits, self._scope)[: job.keep]
            if len(self._tally.findings) >= job.keep:
                return Stopped("past findings stand")
        ending = self._examined()
        self._tally.findings, unrepeated = self._confirmed(self._tally.findings)
        if unrepeated and not self._tally.findings and isinstance(ending, Completed):
            ending = Stopped("what happened to the explorer was not repeated by a fresh process")
        if corpus is not None:
            for lost in corpus.write(self._tally.findings):
                self._tally.remark(lost)
                self._listener.notice(lost)
        return ending

    def _confirmed(self, findings: list[Finding]) -> tuple[list[Finding], bool]:
        """The findings, confirmed; past the time limit as they are.

        A crash or a time-out that a fresh process does not repeat refutes nothing: it becomes a
        remark; then there is more to be said than the findings tell.
        """
        job, corpus = self._job, self._corpus
        kept: list[Finding] = []
        unrepeated = False
        for found in findings:
            late = job.deadline is not None and time.monotonic() > job.deadline
            if late or (corpus and corpus.holds(found)):
                kept.append(found)
                continue
            settled = settled_once(found, self._scope.rules, self._records, self._settled)
            if isinstance(settled, Finding):
                kept.append(settled)
            else:
                unrepeated = True
                self._tally.remark(settled)
        return kept, unrepeated

    def _settled(self, found: Finding) -> Finding | str:
        """The finding as a fresh process has it; a remark if it does not repeat the loss of one."""
        job = self._job
        again = confirmed(found, job.subject, job.limits, self._scope.schedules)
        if again.law not in LOST or not job.subject.importable or again.confirmed:
            return again
        if not again.machine:
            difference = nondeterministic(f"{again.law}, and not in a fresh process: {again.seen}")
            return replace(
                again,
                law=difference.law,
                expected=difference.expected,
                seen=difference.seen,
                confirmed=True,
            )
        size = f"{found.key[0]} edges and {found.key[1]} vertices"
        return (
            f"a {found.law} in a world with {size} ({found.seen}) that a fresh process did "
            "not repeat"
        )

    def _examined(self) -> Ending:
        try:
            ready = self._engine.ready(self._job)
            with ready.transport:
                return self._all_levels(ready)
        except TimeIsUp:
            return Stopped(f"the time limit of {self._job.limits.time_limit:g} s was reached")
        except EnginesDisagree as error:
            return Disagreed(str(error))
        except (Unsettled, ClusterLost) as error:
            return Stopped(str(error))

    def _all_levels(self, ready: ReadyEngine) -> Ending:
        extent, keep = self._scope.extent, self._job.keep
        tell_of_size(extent, self._listener, shards_of(self._scope.coverage))
        for edges in extent.levels:
            self._level(ready, edges)
            self._levels.append(edges)
            if not all(cell.agrees for cell in self._gate):
                return Disagreed("the count gate: the enumeration and its source disagree")
            found = len(self._tally.findings)
            if found >= keep and edges != extent.levels[-1]:
                return Stopped(f"{found} findings in finished levels", enough=True)
        if not self._scope.whole:
            return Completed()
        return Completed(missing_witnesses(extent, self._subject, self._tally.witnesses))

    def _level(self, ready: ReadyEngine, edges: int) -> None:
        """One level, whole: its counts stand in the report only if it is finished."""
        scope, extent = self._scope, self._scope.extent
        self._listener.level(edges, level_size(extent, edges) // shards_of(self._scope.coverage))
        tally = Tally(self._job.keep)
        finished = False
        try:
            shelf = shelf_for(self._records, self._job)
            gather(ready.transport, ready.engine, scope.units(edges), tally, self._listener, shelf)
            finished = True
        finally:
            minimal = finished and scope.whole
            tally.findings = [replace(found, minimal=minimal) for found in tally.findings]
            if finished:
                self._tally.add(tally)
            else:
                for found in tally.findings:
                    self._tally.find(found)
        if scope.whole:
            self._gate += count_gate(extent, edges, tally)
