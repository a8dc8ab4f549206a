"""Worst cases of any explorer: every run is played, under every schedule if it takes choices."""

from __future__ import annotations

from typing import Any

from typing_extensions import override

from allworlds.document import replace
from allworlds.engines import (
    WHOLE,
    AtRun,
    CostTally,
    Identity,
    Listener,
    Portion,
    ReadyEngine,
    Row,
    Scope,
    SweptLevel,
    Tally,
    canonical,
    cells_of_level,
    engine_for,
    from_kept,
    subject_of,
    why_not_compiled,
)
from allworlds.explorers import Subject
from allworlds.judging import Among, Finding
from allworlds.maps import Extent, source_of
from allworlds.outcome import Completed, Disagreed, Ending, Stopped
from allworlds.protocol import Schedule
from allworlds.studies.check import (
    ManyWorlds,
    TallySweep,
    rules_known,
    shared_file,
    subject_of_record,
    world_at,
)
from allworlds.studies.worst.worst_report import WorstReport, WorstRow, replayed_cost
from allworlds.studies.worst.worst_request import WorstRequest
from allworlds.world import World


class _MostExpensive(CostTally):
    """A tally with the cheapest schedules, in place of every run's cost."""

    def add(self, other: Tally) -> None:
        """Add the costs of another part."""
        Tally.add(self, other)
        if isinstance(other, CostTally):
            for vertices, cost in other.best_by_vertices.items():
                self.best_of(vertices, cost)


class RunsSweep(TallySweep[WorstReport]):
    """The sweep through the runs of any explorer. A level with a finding is the last.

    Args:
        request: what was asked for.
        scope: the worlds, the rules and the schedules.
        subject: the explorer.
    """

    verb, asked = "worst", WorstRequest

    def __init__(self, request: WorstRequest, scope: Scope, subject: Subject) -> None:
        super().__init__(request, scope, subject, extent=scope.extent)
        self._rows: list[WorstRow] = []
        self._findings: list[Finding] = []

    @override
    @classmethod
    def known(cls, identity: Identity, portion: Portion, listener: Listener) -> RunsSweep:
        told, request = identity.parameters, cls.asked_then(identity, portion, listener)
        extent = Extent(request.map_class, told["edges"], where=request.where)
        scope = Scope(extent, rules_known(request, told), told["schedules"], portion)
        return cls(request, scope, subject_of_record(identity.explorer))

    @override
    def parameters(self) -> dict[str, Any]:
        scope = self.scope
        more = {"edges": scope.extent.edges, "schedules": scope.schedules}
        return {**super().parameters(), **more}

    @override
    def ready(self) -> ReadyEngine:
        """The engine of a check, which for all schedules also tells the cheapest ones."""
        job, subject, scope = self.seeded, self.job.subject, self.seeded.scope
        job = replace(job, costs=scope.schedules == "all")
        if why := why_not_compiled(scope, subject, job.limits.memory):
            self.listener.notice(why)
        return engine_for("auto", scope, subject, job.limits.memory).ready(job)

    @override
    def forget(self) -> None:
        self._rows.clear()
        self._findings.clear()

    @override
    def empty(self) -> _MostExpensive:
        return _MostExpensive(keep=1)

    @override
    def read(self, kept: Any) -> Tally:
        kind = CostTally if self.scope.schedules == "all" else Tally
        return from_kept(kept, kind).under(self.scope.rules)

    @override
    def finish(self, level: SweptLevel, total: Tally) -> Ending | None:
        extent = self.scope.extent
        cells = cells_of_level(extent, level.edges)
        whole = self.portion == WHOLE and source_of(extent) is not None
        assert isinstance(total, _MostExpensive)
        self._rows += [
            self._row(level.edges, vertices, row, total, cells.get(vertices, 0) if whole else None)
            for (_, vertices), row in sorted(total.rows.items())
            if row.most_expensive
        ]
        self.leave(level, total)
        return Stopped("a law is broken", final=True) if self._findings else None

    @override
    def leave(self, level: SweptLevel, total: Tally) -> None:
        """Store findings, of an unfinished level too."""
        self._findings += total.findings

    @override
    def conclude(self, ending: Ending) -> Ending:
        """Confirm the findings. No level after the first one with a finding is done."""
        self._findings = self.confirmation.confirmed(self._findings)
        return Completed() if ending.final and self._findings else ending

    @override
    def report(self, ending: Ending) -> WorstReport:
        disagreement = ending.reason if isinstance(ending, Disagreed) else ""
        if disagreement:
            self.listener.notice(disagreement)
        return WorstReport(
            **self.ended(ending),
            schedules=self.scope.schedules,
            rows=tuple(self._rows),
            findings=tuple(self._findings),
            disagreement=disagreement,
            subject=self.job.subject,
            rules=self.scope.rules,
        )

    def _row(
        self, edges: int, vertices: int, row: Row, total: _MostExpensive, counted: int | None
    ) -> WorstRow:
        assert row.most_expensive is not None
        world, choices = world_at(row.most_expensive, self.scope.rules), row.most_expensive.choices
        return WorstRow(
            edges=edges,
            vertices=vertices,
            worlds=row.worlds,
            worst=row.max_cost,
            best=total.best.get(vertices, row.max_cost),
            bound=row.bound,
            world=world,
            choices=choices,
            replayed=self._replayed(row.most_expensive, world),
            counted=counted,
        )

    def _replayed(self, run: AtRun, world: World) -> int | None:
        """The cost of a run that is played again; kept on record, so played only once."""
        name = f"replayed {canonical(run)}"
        told: Any = self.records.recall(name)
        if told is None:
            cost = replayed_cost(
                self.job.subject, world, self.scope.rules, run.choices, self.job.limits
            )
            told = {"cost": cost}
            self.records.note(name, told)
        cost_again: int | None = told["cost"]
        return cost_again


def runs_asked(request: WorstRequest, extent: Extent) -> RunsSweep:
    """The search for a request, with its explorer loaded.

    Raises:
        InputError: for an explorer or a lighthouse that is none.
    """
    subject = subject_of(request.explore, request.limits)
    asked = ManyWorlds(
        map_class=request.map_class, lighthouse=request.lighthouse, task=request.task
    )
    schedules: Schedule = "all" if subject.takes_choices else "one"
    rules = asked.rules(subject)
    shared = shared_file(subject.name, rules, extent.where)
    rules = replace(rules, among=Among.of(extent.where), shared_file=shared)
    scope = Scope(extent, rules, schedules, request.shard)
    return RunsSweep(request, scope, subject)
