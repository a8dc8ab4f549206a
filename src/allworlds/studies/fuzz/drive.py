"""A fuzzing run from its options to its report."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

from allworlds.engines import (
    GivenWorlds,
    Listener,
    PythonEngine,
    Sample,
    Scope,
    Silent,
    Tally,
    TimeIsUp,
    Transport,
    confirmed,
    gather,
    subject_of,
    workers_for,
)
from allworlds.explorers import Subject
from allworlds.inputs import (
    InputError,
    an_integer,
    answers,
    show,
)
from allworlds.judging import Finding
from allworlds.maps import Extent
from allworlds.studies.check import CheckReport, ending_of
from allworlds.studies.fuzz.fuzz_request import FuzzRequest
from allworlds.studies.fuzz.sample import batches
from allworlds.studies.fuzz.shrink import shrink

MANY_EDGES = 10_000_000
"""Whoever asks for worlds with more of them in all is told that it takes long."""


@answers(FuzzRequest)
def fuzz(request: FuzzRequest) -> CheckReport:
    """Run an explorer in random worlds of up to ``edges`` edges; shrink what refutes it.

    The report is a sample's: at best ``not-refuted``, never complete.  The sample depends on
    the class, ``edges``, ``min_edges``, ``runs`` and ``seed`` alone, and the finding is the
    smallest that the shrinker reaches from the smallest refuting world of the sample; that may
    have fewer than ``min_edges`` edges.  Shrinking ends with the time limit.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    limits = request.limits
    subject = subject_of(request.explore, limits)
    scope = _scope(request, subject)
    tally = Tally(keep=1)

    def job() -> None:
        with workers_for(subject, limits, limits.deadline()) as workers:
            _try(workers, scope, tally, request.listener)
            shrink_found(workers, scope, tally)
        tally.findings = [
            confirmed(found, subject, limits, scope.schedules) for found in tally.findings
        ]

    ending = ending_of(job, limits)
    return CheckReport(
        explorer=subject.name, engine="python", asked=scope, tally=tally, levels=(), ending=ending
    )


def _scope(request: FuzzRequest, subject: Subject) -> Scope:
    """The worlds that are drawn, and the rules."""
    rules, sample = request.rules(subject), Sample(request.runs, request.seed, request.min_edges)
    edges = an_integer("edges", request.edges)
    if edges < 1:
        raise InputError(f"edges = {show(edges)} is not positive")
    scope = Scope(Extent(request.map_class, edges), rules, coverage=sample)
    if sample.min_edges > edges:
        raise InputError(f"min-edges = {show(sample.min_edges)} is more than edges = {edges}")
    return scope


def _try(workers: Transport[PythonEngine], scope: Scope, tally: Tally, listener: Listener) -> None:
    assert isinstance(scope.coverage, Sample)
    edges, runs = scope.extent.levels[-1], scope.coverage.runs
    if edges * runs > MANY_EDGES:
        listener.notice(
            f"{runs} worlds with up to {edges} edges take long; an interrupt ends it with what is "
            "finished"
        )
    listener.level(edges, runs)
    gather(workers, PythonEngine(scope, tally.keep), batches(scope.coverage), tally, listener)


def shrink_found(workers: Transport[PythonEngine], scope: Scope, tally: Tally) -> None:
    """Put the smallest finding that the shrinker reaches in the place of each one found."""

    def refute(given: Sequence[GivenWorlds]) -> Finding | None:
        found = Tally(keep=1)
        gather(workers, PythonEngine(scope, found.keep), given, found, Silent())
        return found.findings[0] if found.findings else None

    # What has been reached when the time is up is a finding all the same.
    with suppress(TimeIsUp):
        for finding in tally.findings:
            for smaller in shrink(finding, scope, refute):
                tally.findings = [smaller]
