"""The worst of any explorer: every run is played, under every schedule where it takes choices."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from allworlds.engines import (
    AtRun,
    CostEngine,
    CostTally,
    EnginesDisagree,
    Job,
    Limits,
    Listener,
    ReadyEngine,
    Row,
    Scope,
    Tally,
    cells_of_level,
    confirmed,
    engine_for,
    gather,
    subject_of,
    why_not_compiled,
    workers_for,
)
from allworlds.explorers import Subject
from allworlds.judging import Finding, Rules
from allworlds.maps import Extent, source_for
from allworlds.outcome import until_interrupted
from allworlds.studies.check import ManyRuns, world_at
from allworlds.studies.worst.worst_report import WorstReport, WorstRow, replayed_cost
from allworlds.studies.worst.worst_request import WorstRequest

PLAYED = (
    "compiled code tries every schedule of algorithm1 alone; this library takes choices, and is "
    "played by the python engine, far slower"
)
"""The notice for libraries that are played so, where ``check`` judges them in compiled code."""


def worst_of_runs(request: WorstRequest, extent: Extent) -> WorstReport:
    """The worst and best cost of any explorer over its runs, in the worlds of an extent.

    Raises:
        InputError: for an explorer or a lighthouse that is none.
    """
    limits = Limits(workers=request.workers)
    subject = subject_of(request.explore, limits)
    asked = ManyRuns(map_class=request.map_class, lighthouse=request.lighthouse)
    rules = asked.rules(subject)
    scope = Scope(extent, rules, "all" if subject.takes_choices else "one")
    search = _RunsSearch(subject, rules, scope, limits, request.listener)
    finished, complete = until_interrupted(search.levels())
    return WorstReport(
        map_class=extent.map_class,
        edges=extent.levels[-1],
        schedules=scope.schedules,
        complete=complete,
        rows=tuple(row for level in finished for row in level),
        findings=tuple(search.findings),
        source=source_for(extent.map_class).name,
        disagreement=search.disagreement,
        subject=subject,
        rules=rules,
    )


@dataclass(slots=True)
class _MostExpensive(Tally):
    """A tally with the cheapest schedules, in place of every run's cost.

    Attributes:
        best: by vertices the largest, over the runs, of the cost of the cheapest schedule; where
            there is one schedule, nothing.
    """

    best: dict[int, int] = field(default_factory=dict)

    def add(self, other: Tally) -> None:
        """Take in another part."""
        Tally.add(self, other)
        if isinstance(other, CostTally):
            for ((_, vertices, *_), _), cost in other.costs.items():
                self.best[vertices] = max(self.best.get(vertices, 0), cost.cheapest)


@dataclass(slots=True)
class _RunsSearch:
    """On its way."""

    subject: Subject
    rules: Rules
    scope: Scope
    limits: Limits
    listener: Listener
    findings: list[Finding] = field(default_factory=list)
    disagreement: str = ""

    def levels(self) -> Iterator[list[WorstRow]]:
        """The rows of each level; one with a finding is the last."""
        try:
            ready = self._ready()
            with ready.transport:
                for level in self.scope.extent.levels:
                    yield self._level(level, ready)
                    if self.findings:
                        return
        except EnginesDisagree as error:
            self.disagreement = str(error)
            self.listener.notice(self.disagreement)

    def _ready(self) -> ReadyEngine:
        """That of a check of one schedule; of all of them every run must be told apart."""
        subject, scope, limits = self.subject, self.scope, self.limits
        notice = self.listener.notice
        if scope.schedules == "all":
            if subject.compiled:
                notice(PLAYED)
            return ReadyEngine(workers_for(subject, limits), CostEngine(scope, 1))
        if why := why_not_compiled(scope, subject):
            notice(why)
        job = Job(scope, subject, limits, 1, None, notice)
        return engine_for("auto", scope, subject).ready(job)

    def _level(self, level: int, ready: ReadyEngine) -> list[WorstRow]:
        cells = cells_of_level(self.scope.extent, level)
        self.listener.level(level, sum(cells.values()))
        found = _MostExpensive(keep=1)
        gather(ready.transport, ready.engine, self.scope.units(level), found, self.listener)
        self.findings += [
            confirmed(finding, self.subject, self.limits, self.scope.schedules)
            for finding in found.findings
        ]
        return [
            self._row(level, vertices, row, row.most_expensive, found.best, cells.get(vertices, 0))
            for (_, vertices), row in sorted(found.rows.items())
            if row.most_expensive
        ]

    def _row(
        self,
        edges: int,
        vertices: int,
        row: Row,
        most_expensive: AtRun,
        best: Mapping[int, int],
        counted: int,
    ) -> WorstRow:
        world, choices = world_at(most_expensive, self.rules), most_expensive.choices
        return WorstRow(
            edges=edges,
            vertices=vertices,
            worlds=row.worlds,
            worst=row.max_cost,
            best=best.get(vertices, row.max_cost),
            bound=row.bound,
            world=world,
            choices=choices,
            replayed=replayed_cost(self.subject, world, self.rules, choices, self.limits),
            counted=counted,
        )
