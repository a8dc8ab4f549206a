"""A fuzzing run from its options to its report."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any, Unpack

from allworlds.engines import (
    GivenWorlds,
    Limits,
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
from allworlds.inputs import InputError, an_integer, show
from allworlds.judging import Finding
from allworlds.maps import Extent
from allworlds.studies.check import (
    CheckReport,
    ManyRunsOptions,
    ending_of,
    refuse_others,
    rules_for,
)
from allworlds.studies.fuzz.sample import batches
from allworlds.studies.fuzz.shrink import shrink

MANY_EDGES = 10_000_000
"""Whoever asks for worlds with more of them in all is told that it takes long."""


def fuzz(
    explore: str | Callable[..., Any] = "algorithm1",
    *,
    edges: int,
    runs: int,
    seed: int = 0,
    min_edges: int = 1,
    listener: Listener | None = None,
    **options: Unpack[ManyRunsOptions],
) -> CheckReport:
    """Run an explorer in random worlds of up to ``edges`` edges; shrink what refutes it.

    The report is a sample's: at best ``not-refuted``, never complete.  The sample depends on
    the class, ``edges``, ``min_edges``, ``runs`` and ``seed`` alone, and the finding is the
    smallest that the shrinker reaches from the smallest refuting world of the sample.

    Args:
        explore: a name or a generator function.
        edges: the largest number of edges.
        runs: how many worlds, with one start and one place of the lighthouse each.
        seed: another seed, another sample.
        min_edges: the smallest number of edges; what is shrunk may have fewer.
        listener: is told of the progress.
        options: as for :func:`allworlds.check`; shrinking ends with the time limit.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    refuse_others("fuzz", options, ManyRunsOptions)
    limits = Limits.of(options)
    subject = subject_of(explore, limits)
    map_class, rules = rules_for(subject, options)
    sample = Sample(runs, seed, min_edges)
    scope = Scope(Extent(map_class, _positive(edges)), rules, coverage=sample)
    if sample.min_edges > scope.extent.levels[-1]:
        raise InputError(
            f"min-edges = {show(sample.min_edges)} is more than edges = {scope.extent.levels[-1]}"
        )
    tally = Tally(keep=1)

    def job() -> None:
        with workers_for(subject, limits, limits.deadline()) as workers:
            _try(workers, scope, tally, listener or Silent())
            shrink_found(workers, scope, tally)
        tally.findings = [
            confirmed(found, subject, limits, scope.schedules) for found in tally.findings
        ]

    ending = ending_of(job, limits)
    return CheckReport(
        explorer=subject.name, engine="python", asked=scope, tally=tally, levels=(), ending=ending
    )


def _positive(edges: object) -> int:
    number = an_integer("edges", edges)
    if number < 1:
        raise InputError(f"edges = {show(number)} is not positive")
    return number


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
