"""The check of an explorer, level by level, in a class of worlds or in given worlds."""

from collections.abc import Callable, Iterable
from itertools import chain
from typing import Any

from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.engines import single, tally, units
from allworlds.engines.engine_table import (
    ENGINES,
    EngineKind,
    Job,
    ReadyEngine,
    engine_for,
    why_not_compiled,
)
from allworlds.engines.kept_units import Identity
from allworlds.engines.limits import deadline_after
from allworlds.engines.listeners import Listener
from allworlds.inputs.checks import InputError
from allworlds.inputs.requests import answers
from allworlds.studies.check import tally_sweep
from allworlds.studies.check.report import (
    CheckReport,
    CheckRequest,
    GateCell,
    count_gate,
    missing_witnesses,
)
from allworlds.words import plural


@answers(CheckRequest)
def check(request: CheckRequest) -> CheckReport:
    """Run an explorer in every map of a class, from every start, with each place of its lighthouse.

    An explorer that cannot be imported by its name runs in this process.  If it raises a
    KeyboardInterrupt there, the check is interrupted, as if by the user; in a worker a
    KeyboardInterrupt of the explorer is a crash.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    job, chosen = job_of(request, request.listener.notice, request.max_findings)
    return CheckSweep(request, job, chosen).answer(request.run)


def job_of(
    request: CheckRequest, notice: Callable[[str], None], keep: int = 1
) -> tuple[Job, EngineKind]:
    """The job of a request, and the kind of engine that runs the job.

    Args:
        request: the request.
        notice: a function.  If the request leaves the choice of the engine open, and compiled code
            cannot be used, the function is called with the reason.
        keep: the number of findings to keep; the smallest ones are kept.
    """
    limits = request.limits
    subject = single.subject_of(request.explore, limits)
    scope = units.Scope(request.extent, request.rules(subject), request.schedules, request.shard)
    if scope.schedules == "all" and not subject.takes_choices:
        raise InputError(f"schedules 'all' needs an explorer with choices; {subject.name} has none")
    if request.engine == "auto" and (why := why_not_compiled(scope, subject, limits.memory)):
        notice(why)
    deadline = deadline_after(limits.time_limit)
    job = Job(scope, subject, limits, keep, deadline, notice, request.dask)
    return job, engine_for(request.engine, scope, subject, limits.memory)


class CheckSweep(tally_sweep.TallySweep[CheckReport]):
    """The sweep of a check, which goes through its levels and makes its report.

    Args:
        request: the request.
        job: the explorer and the scope of the check.
        engine: the kind of engine that runs the units.
    """

    verb, request_type = "check", CheckRequest

    def __init__(self, request: CheckRequest, job: Job, engine: EngineKind) -> None:
        super().__init__(request, job.scope, job.subject, job.keep, job.scope.extent)
        self._engine = engine
        self._tally = self.empty()
        self._levels: list[int] = []
        self._gate: list[GateCell] = []

    @override
    @classmethod
    def known(cls, identity: Identity, portion: units.Shard, listener: Listener) -> "CheckSweep":
        request = cls.request_of(identity, portion, listener)
        rules = tally_sweep.rules_known(request, identity.parameters)
        scope = units.Scope(request.extent, rules, request.schedules, portion)
        subject = tally_sweep.subject_of_record(identity.explorer)
        job = Job(scope, subject, request.limits, request.max_findings, None, listener.notice)
        return cls(request, job, ENGINES[request.engine])

    @override
    def parameters(self) -> dict[str, Any]:
        decided = {"edges": self.scope.extent.edges, "engine": self._engine.name}
        return {**super().parameters(), **decided}

    @override
    def levels(self) -> Iterable[units.SweptLevel]:
        """Yield the levels, with all their units.

        For a user's explorer, small levels have one more unit (:func:`units.across_level`), which
        tests whether one run of the explorer changes a later run.
        """
        for level in super().levels():
            across = units.across_level(self.scope.extent, level.edges, self.portion)
            subject = self.job.subject
            more = across if subject.from_user and subject.importable else ()
            yield doc.replace(level, units=chain(level.units, more))

    @override
    def ready(self) -> ReadyEngine:
        return self._engine.ready(self.job)

    @override
    def begin(self) -> outcome.Ending | None:
        """Try again the findings in the user's corpus, a directory of earlier findings.

        If the check keeps K findings, and K past findings or more are reproduced, return the ending
        with which the check ends; otherwise return None.
        """
        return self.retry_past(self._tally)

    @override
    def finish(self, level: units.SweptLevel, total: tally.Tally) -> outcome.Ending | None:
        scope, extent = self.scope, self.scope.extent
        total.findings = [doc.replace(found, minimal=scope.whole) for found in total.findings]
        self._tally.add(total)
        self._levels.append(level.edges)
        if scope.whole:
            self._gate += count_gate(extent, level.edges, total)
        if not all(cell.agrees for cell in self._gate):
            return outcome.Disagreed("a fault of allworlds: the maps are wrong, as the gate says")
        if level.edges == extent.levels[-1]:
            seen, task = self._tally.witnesses, scope.rules.task
            missing = missing_witnesses(extent, self.job.subject, task, seen)
            return outcome.Completed(missing if scope.whole else ())
        if (found := len(self._tally.findings)) >= self.job.keep:
            return outcome.Stopped(f"ended after {plural(found, 'finding')}", final=True)
        return None

    @override
    def leave(self, level: units.SweptLevel, total: tally.Tally) -> None:
        """Keep the findings of an unfinished level; its counts do not enter the report."""
        for found in total.findings:
            self._tally.find(doc.replace(found, minimal=False))

    @override
    def conclude(self, ending: outcome.Ending) -> outcome.Ending | None:
        """Confirm the findings, and add new findings to the user's corpus.

        There is one case in which the check does not end with ``ending``.  It was completed or had
        enough findings, but a fresh process repeated none of its findings, so that no finding is
        left.  Then the explorer may break a law all the same, and the check proves nothing: the
        method returns :class:`Stopped`.  In all other cases it returns None, and the check ends
        with ``ending``.
        """
        corpus = self.corpus
        self._tally.findings = [*map(self.scope.labelled, self._tally.findings)]
        known = corpus.holds if corpus is not None else None
        unrepeated = self.confirmation.settle(self._tally, known)
        self.keep_new(self._tally)
        match ending:
            case outcome.Completed() | outcome.Stopped(final=True) if unrepeated:
                return None if self._tally.findings else outcome.Stopped(tally_sweep.UNREPEATED)
        return None

    @override
    def report(self, ending: outcome.Ending) -> CheckReport:
        report = CheckReport(
            **self.ended(ending, self.scope.extent),
            explorer=self.job.subject.name,
            engine=self._engine.name,
            asked=self.scope,
            tally=self._tally,
            levels=tuple(self._levels),
            cells=tuple(self._gate),
            past=self.corpus,
            symmetry=self._engine.symmetry(self.scope, self.job.subject),
            seconds=tuple(self.seconds),
        )
        if report.runs and not self._tally.traversals and report.verdict is outcome.Verdict.HOLDS:
            self.listener.notice("every run holds, and none of them has walked an edge")
        return report
