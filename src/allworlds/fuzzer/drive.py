"""A fuzzing run from its options to its report."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from allworlds.checker.drive import Listener, Silent
from allworlds.checker.finding import Finding
from allworlds.checker.laboratory import Laboratory
from allworlds.checker.pool import Pool, TimeIsUp
from allworlds.checker.report import Report
from allworlds.checker.scope import Limits, Picked, make_scope
from allworlds.checker.tally import Tally
from allworlds.fuzzer.sample import Sample
from allworlds.fuzzer.shrink import shrink
from allworlds.maps.classes import MapClass
from allworlds.subjects import default_lighthouse, own_bound, subject_of


def fuzz(
    explore: str | Callable[..., Any] = "algorithm1",
    *,
    edges: int,
    runs: int,
    seed: int = 0,
    map_class: str = "maps",
    lighthouse: str | None = None,
    policy: str = "fifo",
    bound: str | int | None = None,
    laws: Iterable[str] | None = None,
    step_budget: int | None = None,
    workers: int = 1,
    answer_timeout: float = 10.0,
    time_limit: float | None = None,
    memory: int | None = None,
    listener: Listener | None = None,
) -> Report:
    """Run an explorer in random worlds of up to ``edges`` edges; shrink what refutes it.

    The report is a sample's: at best ``not-refuted``, never complete.  The sample depends on
    the class, ``edges``, ``runs`` and ``seed`` alone, and the finding is the smallest that
    the shrinker reaches from the smallest refuting world of the sample.

    Args:
        explore: a name or a generator function.
        edges: the largest number of edges.
        runs: how many worlds, with one start and one place of the lighthouse each.
        seed: another seed, another sample.
        map_class: ``maps``, ``simple``, ``planar`` or ``planar-simple``.
        lighthouse: ``KIND[:key=value,...]``; None takes the explorer's own.
        policy: ``fifo``, ``lifo``, ``nearest`` or ``random:SEED``.
        bound: ``paper``, ``two-vertices``, ``none``, an expression or an integer; None takes
            the explorer's own, else the lighthouse's.
        laws: those to check; None takes all that apply.
        step_budget: the largest legal number of traversals.
        workers: processes.
        answer_timeout: seconds of silence after which the explorer is killed.
        time_limit: seconds for everything; shrinking ends with it.
        memory: MB of address space of a worker.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    limits = Limits(workers, answer_timeout, time_limit, memory)
    subject = subject_of(explore, answer_timeout)
    lighthouse = default_lighthouse(subject.name) if lighthouse is None else lighthouse
    scope = make_scope(
        edges=edges,
        map_class=map_class,
        lighthouse=lighthouse,
        policy=policy,
        bound=bound,
        own_bound=own_bound(subject.name, lighthouse),
        laws=laws,
        step_budget=step_budget,
    )
    sample = Sample(MapClass(map_class), edges, runs, seed)
    scope = replace(scope, sample=sample.to_json())
    report = Report(subject.name, "python", scope, Tally(limits.max_findings))
    laboratory = Laboratory(scope, subject, limits)
    try:
        with laboratory.open() as pool:
            _examine(laboratory, pool, sample, report, listener or Silent())
            _shrink(laboratory, pool, report)
        report.tally.findings = [laboratory.confirmed(f) for f in report.findings]
    except TimeIsUp:
        report.stopped = f"the time limit of {limits.time_limit:g} s was reached"
    except KeyboardInterrupt:
        report.stopped, report.interrupted = "interrupted", True
    return report


def _examine(
    laboratory: Laboratory, pool: Pool, sample: Sample, report: Report, listener: Listener
) -> None:
    listener.level(sample.edges, sample.runs)
    for part in laboratory.examine(pool, sample.batches()):
        report.tally.add(part)
        listener.progress(part.worlds)


def _shrink(laboratory: Laboratory, pool: Pool, report: Report) -> None:
    def refute(picked: Sequence[Picked]) -> Finding | None:
        tally = Tally(1)
        for part in laboratory.examine(pool, picked):
            tally.add(part)
        return tally.findings[0] if tally.findings else None

    # What has been reached when the time is up is a finding all the same.
    with suppress(TimeIsUp):
        for finding in report.findings:
            for smaller in shrink(finding, laboratory.scope, refute):
                report.tally.findings = [smaller]
