"""Level by level: the exhaustive check from its options to its report."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from typing import Any, Protocol

from allworlds.checker.confirm import repeat, trace, unearth
from allworlds.checker.finding import Finding
from allworlds.checker.pool import LocalPool, Poisoned, Pool, TimeIsUp, WorkerPool
from allworlds.checker.report import Cell, Report, Verdict
from allworlds.checker.scope import Limits, Scope, ScopeError, Shard, make_scope
from allworlds.checker.tally import Tally
from allworlds.maps.classes import Bounds
from allworlds.maps.counting import source_for
from allworlds.subjects import Subject, subject_of


class Listener(Protocol):
    """Is told how a check gets on."""

    def level(self, edges: int, worlds: int) -> None:
        """A level begins; it holds so many worlds (a shard: about so many)."""

    def progress(self, worlds: int) -> None:
        """So many more worlds are done."""


class Silent:
    """The listener who is not there."""

    def level(self, edges: int, worlds: int) -> None:
        """Nothing."""

    def progress(self, worlds: int) -> None:
        """Nothing."""


def check(
    explore: str | Callable[..., Any] = "algorithm1",
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = "maps",
    lighthouse: str = "directional",
    policy: str = "fifo",
    schedules: str = "one",
    bound: str = "",
    laws: Iterable[str] = (),
    step_budget: int | None = None,
    shard: Shard = (0, 1),
    workers: int = 1,
    answer_timeout: float = 10.0,
    time_limit: float | None = None,
    memory: int | None = None,
    max_findings: int = 1,
    engine: str = "auto",
    listener: Listener | None = None,
) -> Report:
    """Run an explorer on every start and every marker orientation of every map in a class.

    Args:
        explore: a name (see :func:`allworlds.subjects.load`) or a generator function.
        edges: the largest number of edges (default: one that takes seconds).
        vertices: the largest number of vertices.
        map_class: ``maps``, ``simple``, ``planar`` or ``planar-simple``.
        lighthouse: ``KIND[:key=value,...]``.
        policy: ``fifo``, ``lifo``, ``nearest`` or ``random:SEED``.
        schedules: ``one`` or ``all``.
        bound: ``paper``, ``none`` or an expression; empty takes the lighthouse's own.
        laws: those to check; empty takes all that apply.
        step_budget: the largest legal number of traversals.
        shard: ``(K, N)``.
        workers: processes.
        answer_timeout: seconds of silence after which the explorer is killed.
        time_limit: seconds for everything.
        memory: MB of address space of a worker.
        max_findings: with so many findings in finished levels the check ends.
        engine: ``auto`` or ``python``.
        listener: is told of the progress.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    if engine not in ("auto", "python"):
        raise ScopeError(f"engine {engine!r} is none of auto, python")
    limits = Limits(workers, answer_timeout, time_limit, memory, max_findings)
    subject = subject_of(explore, answer_timeout)
    scope = make_scope(
        edges=edges,
        vertices=vertices,
        map_class=map_class,
        lighthouse=lighthouse,
        policy=policy,
        schedules=schedules,
        bound=bound,
        laws=tuple(laws),
        step_budget=step_budget,
        shard=shard,
    )
    if schedules == "all" and not subject.takes_choices:
        raise ScopeError(f"schedules 'all' needs an explorer with choices; {subject.name} has none")
    return _Drive(scope, subject, limits, listener or Silent()).run()


class _Drive:
    """One check on its way."""

    def __init__(self, scope: Scope, subject: Subject, limits: Limits, listener: Listener) -> None:
        self._scope, self._subject, self._limits = scope, subject, limits
        self._listener = listener
        self._deadline = limits.time_limit and time.monotonic() + limits.time_limit
        self._report = Report(subject.name, "python", scope, Tally(limits.max_findings))
        self._lost: set[object] = set()

    def run(self) -> Report:
        report = self._report
        try:
            with self._pool() as pool:
                self._levels(pool)
        except TimeIsUp:
            report.stopped = f"the time limit of {self._limits.time_limit:g} s was reached"
        except KeyboardInterrupt:
            report.stopped, report.interrupted = "interrupted", True
        if not report.interrupted:
            report.tally.findings = [self._confirmed(found) for found in report.findings]
        return report

    def _pool(self) -> AbstractContextManager[Pool]:
        if self._subject.importable:
            return WorkerPool(self._subject, self._limits, self._deadline)
        return nullcontext(LocalPool(self._subject, self._deadline))

    def _levels(self, pool: Pool) -> None:
        report, scope = self._report, self._scope
        for edges in scope.bounds.levels:
            self._level(pool, edges)
            report.levels.append(edges)
            if report.verdict is Verdict.ERROR:
                report.stopped = "the count gate: the enumeration and its source disagree"
                return
            if len(report.findings) >= self._limits.max_findings:
                break
        report.complete = report.levels == list(scope.bounds.levels)
        if not report.complete:
            report.stopped = f"{len(report.findings)} findings in finished levels"
        elif scope.shard == (0, 1):
            report.missing = self._missing_witnesses()

    def _level(self, pool: Pool, edges: int) -> None:
        """One level, whole: its counts stand in the report only if it is finished."""
        report, scope, keep = self._report, self._scope, self._limits.max_findings
        cells = source_for(scope.bounds.map_class).cells(edges)
        limit = scope.bounds.vertex_limit(edges)
        total = sum(cells.get(n, 0) for n in range(1, limit + 1))
        self._listener.level(edges, total // scope.shard[1])
        tally = Tally(keep)
        finished = False
        try:
            for part in pool.examine(scope, scope.units(edges), keep):
                if isinstance(part, Poisoned):
                    found = unearth(part, scope, self._subject)
                    self._lost.add(found.key[:4])
                    tally.find(found)
                else:
                    tally.add(part)
                    self._listener.progress(part.worlds)
            finished = True
        finally:
            minimal = finished and scope.shard == (0, 1)
            tally.findings = [replace(found, minimal=minimal) for found in tally.findings]
            if finished:
                report.tally.add(tally)
            else:
                for found in tally.findings:
                    report.tally.find(found)
        if scope.shard == (0, 1):
            report.gate += count_gate(scope.bounds, edges, tally)

    def _confirmed(self, finding: Finding) -> Finding:
        subject, limits = self._subject, self._limits
        if not subject.importable:
            return finding
        if finding.law in ("timeout", "crash") and finding.key[:4] in self._lost:
            return trace(finding, self._scope, subject, limits)
        return replace(finding, confirmed=repeat(finding, subject, limits))

    def _missing_witnesses(self) -> list[str]:
        """The events that this scope must have seen and has not."""
        scope, seen = self._scope, self._report.tally.witnesses
        simple, last = scope.bounds.map_class.simple, max(scope.bounds.levels)
        required = {} if simple else {"loop-edge": 1, "parallel-edge": 2}
        required |= {
            event: least[1] if simple else least[0]
            for event, least in self._subject.witnesses.items()
        }
        return sorted(
            event for event, least in required.items() if least <= last and not seen[event]
        )


def count_gate(bounds: Bounds, edges: int, tally: Tally) -> list[Cell]:
    """What was enumerated on a level beside what an independent source counts."""
    source = source_for(bounds.map_class)
    counted = source.cells(edges)
    cells = []
    for vertices in range(1, bounds.vertex_limit(edges) + 1):
        row = tally.rows.get((edges, vertices))
        enumerated = row.worlds if row else 0
        known = counted.get(vertices, 0)
        if enumerated or known:
            cells.append(Cell(edges, vertices, enumerated, known, source.name))
    return cells
