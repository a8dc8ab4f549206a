"""Level by level: the exhaustive check from its options to its report."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol

from allworlds.checker.engines import Engine, engine_for
from allworlds.checker.laboratory import Laboratory
from allworlds.checker.past import Past
from allworlds.checker.pool import Pool, TimeIsUp
from allworlds.checker.report import Cell, Report, Verdict
from allworlds.checker.scope import Limits, Scope, ScopeError, Shard, make_scope
from allworlds.checker.tally import Tally
from allworlds.errors import a_path
from allworlds.maps.classes import Bounds
from allworlds.maps.counting import source_for
from allworlds.subjects import Subject, default_lighthouse, own_bound, subject_of


class Listener(Protocol):
    """Is told how a check gets on."""

    def level(self, edges: int, worlds: int) -> None:
        """A level begins; it holds so many worlds (a shard: about so many)."""

    def progress(self, worlds: int) -> None:
        """So many more worlds are done."""

    def notice(self, text: str) -> None:
        """Something that the user may want to know now."""


class Silent:
    """The listener who is not there."""

    def level(self, edges: int, worlds: int) -> None:
        """Nothing."""

    def progress(self, worlds: int) -> None:
        """Nothing."""

    def notice(self, text: str) -> None:
        """Nothing."""


def check(
    explore: str | Callable[..., Any] = "algorithm1",
    *,
    edges: int | None = None,
    vertices: int | None = None,
    map_class: str = "maps",
    lighthouse: str | None = None,
    policy: str = "fifo",
    schedules: str = "one",
    bound: str | int | None = None,
    laws: Iterable[str] | None = None,
    step_budget: int | None = None,
    shard: Shard = (0, 1),
    workers: int = 1,
    answer_timeout: float = 10.0,
    time_limit: float | None = None,
    memory: int | None = None,
    max_findings: int = 1,
    engine: str = "auto",
    corpus: str | Path | None = None,
    listener: Listener | None = None,
) -> Report:
    """Run an explorer on every start and every marker orientation of every map in a class.

    Args:
        explore: a name (see :func:`allworlds.subjects.load`) or a generator function.
        edges: the largest number of edges (default: one that takes seconds).
        vertices: the largest number of vertices.
        map_class: ``maps``, ``simple``, ``planar`` or ``planar-simple``.
        lighthouse: ``KIND[:key=value,...]``; None takes the explorer's own, which is
            ``directional`` unless a built-in explorer is written for another.
        policy: ``fifo``, ``lifo``, ``nearest`` or ``random:SEED``.
        schedules: ``one`` or ``all``.
        bound: ``paper``, ``two-vertices``, ``none``, an expression or an integer; None takes
            the explorer's own, else the lighthouse's.
        laws: those to check; None takes all that apply.
        step_budget: the largest legal number of traversals.
        shard: ``(K, N)``.
        workers: processes.
        answer_timeout: seconds of silence after which the explorer is killed.
        time_limit: seconds for everything.
        memory: MB of address space of a worker.
        max_findings: with so many findings in finished levels the check ends.
        engine: ``auto``, ``python`` or ``kernel``.
        corpus: a directory of past findings, which are tried first; new ones are written
            to it.
        listener: is told of the progress.

    An explorer that cannot be imported by its name runs in this process, where its
    KeyboardInterrupt cannot be told from the user's: it interrupts the check.  In a worker it
    is a crash.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    limits = Limits(workers, answer_timeout, time_limit, memory, max_findings)
    subject = subject_of(explore, answer_timeout)
    lighthouse = default_lighthouse(subject.name) if lighthouse is None else lighthouse
    scope = make_scope(
        edges=edges,
        vertices=vertices,
        map_class=map_class,
        lighthouse=lighthouse,
        policy=policy,
        schedules=schedules,
        bound=bound,
        own_bound=own_bound(subject.name, lighthouse),
        laws=laws,
        step_budget=step_budget,
        shard=shard,
    )
    if schedules == "all" and not subject.takes_choices:
        raise ScopeError(f"schedules 'all' needs an explorer with choices; {subject.name} has none")
    chosen = engine_for(engine, scope, subject)
    directory = None if corpus is None else a_path("corpus", corpus)
    return _Drive(scope, subject, limits, listener or Silent(), chosen, directory).run()


class _Drive:
    """One check on its way."""

    def __init__(
        self,
        scope: Scope,
        subject: Subject,
        limits: Limits,
        listener: Listener,
        engine: Engine,
        corpus: Path | None,
    ) -> None:
        self._scope, self._subject, self._limits = scope, subject, limits
        self._listener = listener
        self._laboratory = Laboratory(scope, subject, limits)
        self._report = Report(subject.name, engine, scope, Tally(limits.max_findings))
        self._past = None if corpus is None else Past(corpus)

    def run(self) -> Report:
        report = self._report
        try:
            if self._past is not None:
                report.corpus = self._past
                report.tally.findings = self._past.retry(self._subject, self._limits)
            if len(report.findings) < self._limits.max_findings:
                self._examine()
                self._confirm()
            else:
                report.stopped = "past findings stand"
        except KeyboardInterrupt:
            report.stopped, report.interrupted = "interrupted", True
        if report.runs and not report.tally.traversals and report.verdict is Verdict.HOLDS:
            self._listener.notice("every run holds, and none of them has walked an edge")
        return report

    def _confirm(self) -> None:
        report, past = self._report, self._past
        report.tally.findings = [
            found if past and past.holds(found) else self._laboratory.confirmed(found)
            for found in report.findings
        ]
        if past is not None:
            past.write(report.findings)

    def _examine(self) -> None:
        try:
            if self._report.engine == "kernel":
                self._examine_compiled()
                return
            with self._laboratory.open() as pool:
                self._levels(pool)
        except TimeIsUp:
            self._report.stopped = f"the time limit of {self._limits.time_limit:g} s was reached"

    def _examine_compiled(self) -> None:
        """The same with the compiled engine in the place of worker processes."""
        from allworlds.checker.kernel_pool import SYMMETRY, EnginesDisagree, KernelPool

        self._report.symmetry = SYMMETRY
        try:
            with KernelPool(self._subject, self._limits, self._listener.notice) as pool:
                self._levels(pool)
        except EnginesDisagree as error:
            self._report.stopped = self._report.disagreement = str(error)

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
        report.complete = report.levels[-1] == scope.bounds.levels[-1]
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
            for part in self._laboratory.examine(pool, scope.units(edges)):
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

    def _missing_witnesses(self) -> list[str]:
        """The events that this scope must have seen and has not."""
        bounds, seen = self._scope.bounds, self._report.tally.witnesses
        simple, last = bounds.map_class.simple, bounds.levels[-1]
        required = {} if simple else {"loop-edge": (1, 1), "parallel-edge": (2, 1)}
        for event, least in self._subject.witnesses.items():
            if (size := least[simple]) is not None:
                required[event] = size
        return sorted(
            event
            for event, (edges, vertices) in required.items()
            if edges <= last and vertices <= bounds.vertex_limit(last) and not seen[event]
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
