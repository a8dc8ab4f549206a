"""A check, level by level to a report, in worlds of the user's own, too; and how long it takes."""

import time
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from itertools import islice
from random import Random
from typing import Annotated, Any, TypeAlias

from typing_extensions import override

from allworlds import document as doc, outcome
from allworlds.engines import limits, players, single, tally, units
from allworlds.engines.engine_table import (
    ENGINES,
    EngineKind,
    EngineName,
    Job,
    ReadyEngine,
    engine_for,
    why_not_compiled,
)
from allworlds.engines.job_records import Identity
from allworlds.engines.limits import deadline_after
from allworlds.inputs.checks import InputError
from allworlds.inputs.requests import answers
from allworlds.judging.findings.finding import labelled
from allworlds.maps import classes
from allworlds.studies.check import tally_sweep
from allworlds.studies.check.report import (
    CheckReport,
    CheckRequest,
    GateCell,
    count_gate,
    missing_witnesses,
)


@answers(CheckRequest)
def check(request: CheckRequest) -> CheckReport:
    """Run an explorer on every start and every marker orientation of every map in a class.

    An explorer that cannot be imported by its name runs in this process, where its
    KeyboardInterrupt cannot be told from the user's: it interrupts the check.  In a worker it
    is a crash.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    job, chosen = _job(request, request.listener.notice, request.max_findings)
    return CheckSweep(request, job, chosen).answer(request.run)


@answers(CheckRequest)
def estimate(request: CheckRequest) -> "TimeEstimate":
    """Estimate the duration of :func:`check` with these options, from a sample of some seconds.

    And with one edge more, by the engine that would do it.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if request.given is not None:
        raise InputError(f"estimate is of a class, and not of {request.given.words}")
    once = cache(request.listener.notice)
    job, chosen = _job(request, once)
    guess, larger = estimated(job, chosen), tuple[Guess, ...]()
    if guess.rate and (extent := one_larger(job)):
        # What an engine cannot do ends the table.
        with suppress(InputError):
            larger = (estimated(*_job(doc.replace(request, edges=extent.edges), once)),)
    counted = units.is_counted(job.scope.extent)
    first = {name: getattr(guess, name) for name in guess.__struct_fields__}
    return TimeEstimate(explorer=job.subject.name, larger=larger, counted=counted, **first)


def _job(
    request: CheckRequest, notice: Callable[[str], None], keep: int = 1
) -> tuple[Job, EngineKind]:
    """The job of a request, and the engine for it."""
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
    """The sweep of a check.

    Args:
        request: what was asked for.
        job: what is checked.
        engine: what does it.
    """

    verb, asked = "check", CheckRequest

    def __init__(self, request: CheckRequest, job: Job, engine: EngineKind) -> None:
        super().__init__(request, job.scope, job.subject, job.keep, job.scope.extent)
        self._engine = engine
        self._tally = self.empty()
        self._levels: list[int] = []
        self._gate: list[GateCell] = []

    @override
    @classmethod
    def known(
        cls, identity: Identity, portion: units.Shard, listener: limits.Listener
    ) -> "CheckSweep":
        request = cls.asked_then(identity, portion, listener)
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
    def ready(self) -> ReadyEngine:
        return self._engine.ready(self.job)

    @override
    def begin(self) -> outcome.Ending | None:
        """Try past findings."""
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
            return outcome.Disagreed("the count gate: the enumeration and its source disagree")
        if level.edges == extent.levels[-1]:
            seen, task = self._tally.witnesses, scope.rules.task
            missing = missing_witnesses(extent, self.job.subject, task, seen)
            return outcome.Completed(missing if scope.whole else ())
        if (found := len(self._tally.findings)) >= self.job.keep:
            return outcome.Stopped(f"{found} findings in finished levels", final=True)
        return None

    @override
    def leave(self, level: units.SweptLevel, total: tally.Tally) -> None:
        """Store the findings. Counts enter the report only if their level is finished."""
        for found in total.findings:
            self._tally.find(doc.replace(found, minimal=False))

    @override
    def conclude(self, ending: outcome.Ending) -> outcome.Ending:
        """Confirm the findings, and store them."""
        corpus, like = self.corpus, self.scope.like
        self._tally.findings = [
            doc.replace(found, world=labelled(found.world, like(found.world)))
            for found in self._tally.findings
        ]
        known = corpus.holds if corpus is not None else None
        unrepeated = self.confirmation.settle(self._tally, known)
        self.keep_new(self._tally)
        if unrepeated and not self._tally.findings and isinstance(ending, outcome.Completed):
            return outcome.Stopped(tally_sweep.UNREPEATED)
        return ending

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


# ---------------------------------------------------------------- the time

SECONDS = 2.0
"""Seconds that a sample takes from its first piece on."""

MOST_SECONDS = 4.0
"""Seconds that it takes at most, besides compiling, once on a machine; samples are at most two.
Where no piece is done by then there is no guess."""

FEW, MANY = 200, 200_000
"""The most worlds in a piece of the sample, played in Python, or by compiled code."""

LONGEST = 1e300
"""Seconds; what takes longer is said to take as long."""

PIECES = 2000

COUNTABLE = 16
"""Levels of more edges are not counted for this; that they are many is said without it."""


Largest: TypeAlias = Annotated[doc.Positive, doc.about("of the largest worlds")]
Doer: TypeAlias = Annotated[EngineName, doc.about("the engine that would run it")]
ToBeTried: TypeAlias = Annotated[
    doc.Natural,
    doc.about(
        "rooted maps that are to be tried; under a condition without a source at most so many"
    ),
]
Sampled: TypeAlias = Annotated[
    doc.Natural,
    doc.about("rooted maps of the last level that were tried for this; 0: the rate is a guess"),
]
Rate: TypeAlias = Annotated[
    doc.Figure | None, doc.about("of these a second; null: none was finished in time")
]


class _Lasting:
    """The time that so many ``worlds`` take at that ``rate``."""

    worlds: int
    rate: float | None

    @doc.computed
    def seconds(self) -> doc.Seconds | None:
        """For all: a guess, since smaller worlds take less; null where there is no rate."""
        if not self.rate:
            return None
        if self.worlds > LONGEST * self.rate:
            return LONGEST
        return round(self.worlds / self.rate, 1)


class Guess(doc.Document, _Lasting):
    """Estimated duration of a check with this number of edges."""

    edges: Largest
    engine: Doer
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate


class TimeEstimate(doc.Report, _Lasting):
    """Estimate.

    How long a check will take: what `check --estimate` writes.

    ``counted`` tells that the worlds were counted, and are not at most so many.
    """

    explorer: Annotated[doc.Text, doc.about("its name")]
    edges: Largest
    engine: Doer
    worlds: ToBeTried
    sampled: Sampled
    rate: Rate
    larger: Annotated[tuple[Guess, ...], doc.about("the same check with more edges")]
    counted: doc.NotInDocument[bool] = True


def worlds_of(job: Job) -> int:
    """The number of worlds to be tried; for a shard an estimate."""
    extent = job.scope.extent
    worlds = sum(units.level_size(extent, edges) for edges in extent.levels)
    return worlds // job.scope.portion.count


def estimated(job: Job, engine: EngineKind) -> Guess:
    """A guess from pieces of the last level, which are drawn like its maps.

    What starts workers and compiles is not counted; the sample takes some seconds.
    """
    engine.ready(job)  # compiles, where that is still to be done
    ready = engine.ready(doc.replace(job, deadline=time.monotonic() + MOST_SECONDS))
    extent, draw = job.scope.extent, Random(0)  # noqa: S311  # the same pieces each time
    sampled, began, ended = 0, 0.0, 0.0
    slow = engine.name == "python" or (job.subject.from_user and not job.subject.compiled)
    try:
        drawn = units.drawn_units(extent, extent.levels[-1], FEW if slow else MANY, draw)
        with ready.transport as transport:
            for part in transport.map(ready.engine, islice(drawn, PIECES)):
                now = time.monotonic()
                if not began:
                    began = now
                    continue
                sampled, ended = sampled + part.result.worlds, now
                if sampled and now > began + SECONDS:
                    break
    except (limits.TimeIsUp, tally.EnginesDisagree, limits.ClusterLost, players.Unsettled):
        pass  # the check itself will say so
    rate = sampled / (ended - began) if ended > began and sampled else None
    return Guess(
        edges=extent.levels[-1],
        engine=engine.name,
        worlds=worlds_of(job),
        sampled=sampled,
        rate=None if rate is None else round(rate, 3),
    )


def one_larger(job: Job) -> classes.Extent | None:
    """The extent with one edge more; None where that holds no more worlds, or too many to count."""
    extent = job.scope.extent
    if extent.edges is None or extent.edges >= COUNTABLE:
        return None
    edges = extent.edges + 1
    larger = doc.replace(extent, edges=edges)
    return larger if units.level_size(larger, edges) else None
