"""The worst of any explorer: every run is played, under every schedule where it takes choices."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from allworlds.engines import (
    AtRun,
    CostEngine,
    CostTally,
    EnginesDisagree,
    Job,
    Limits,
    ReadyEngine,
    Row,
    Schedule,
    Scope,
    SingleRun,
    Tally,
    cells_of_level,
    confirmed,
    engine_for,
    gather,
    single_run,
    subject_of,
    why_not_compiled,
    workers_for,
)
from allworlds.explorers import Subject
from allworlds.judging import Finding, Rules
from allworlds.maps import Extent, source_for
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener
from allworlds.studies.check import rules_for, world_at
from allworlds.world import World

if TYPE_CHECKING:
    from allworlds import documents


PLAYED = (
    "compiled code tries every schedule of algorithm1 alone; this library takes choices, and is "
    "played by the python engine, far slower"
)
"""The notice for libraries that are played so, where ``check`` judges them in compiled code."""


@dataclass(frozen=True, slots=True)
class RunsRow:
    """What runs cost in the worlds of one size.

    Attributes:
        edges, vertices: the size.
        worlds: rooted maps, with those in which the lighthouse has no place.
        worst: the largest cost of an episode.
        best: the largest, over the runs, of the cost of the cheapest schedule.
        bound: the largest bound of a run; None without a bound.
        counted: rooted maps according to the independent source.
        world: the least world that attains the worst cost.
        choices: the choices that attain it there.
        replayed: what they cost when they are taken again; None if a law was broken then.
    """

    edges: int
    vertices: int
    worlds: int
    worst: int
    best: int
    bound: int | None
    counted: int
    world: World
    choices: tuple[int, ...]
    replayed: int | None

    @property
    def agrees(self) -> bool:
        """The count and the replay say the same."""
        return self.worlds == self.counted and self.replayed == self.worst

    def to_json(self) -> documents.WorstRowDocument:
        """One row of the document."""
        return {
            "edges": self.edges,
            "vertices": self.vertices,
            "worlds": self.worlds,
            "worst": self.worst,
            "best": self.best,
            "bound": self.bound,
            "tests": None,
            "wrong_tests": None,
            "world": self.world.to_json(),
            "choices": list(self.choices),
            "replayed": self.replayed,
        }


@dataclass(frozen=True, slots=True)
class RunsReport:
    """The worst and best costs of an explorer's runs, by size.

    Attributes:
        explorer: its name.
        extent: class and bounds.
        lighthouse: where it was run.
        schedules: ``all`` where it takes choices, else ``one``.
        source: the independent source of the counts.
        rows: ascending by (edges, vertices).
        findings: the smallest, if a run broke a law; its level is the last.
        disagreement: what two engines say differently of one world, if they do; else empty.
        complete: False if the user has interrupted, and levels are missing.
        subject, rules: who was run, and how.
    """

    explorer: str
    extent: Extent
    lighthouse: str
    schedules: Schedule
    source: str
    rows: tuple[RunsRow, ...]
    findings: tuple[Finding, ...]
    disagreement: str
    complete: bool
    subject: Subject = field(compare=False)
    rules: Rules = field(compare=False)

    def walks(self) -> Iterator[SingleRun]:
        """The runs that attain each row's worst cost, played again."""
        for row in self.rows:
            yield single_run(self.subject, row.world, self.rules, row.choices, Limits())

    @property
    def agrees(self) -> bool:
        """Engines, counts and replays agree with what was played."""
        if self.disagreement:
            return False
        return bool(self.findings) or all(row.agrees for row in self.rows)

    @property
    def exit_code(self) -> Exit:
        """0 answered, 1 refuted, 4 no run, 70 engines or counts disagree, 130 interrupted."""
        if not self.agrees:
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        if self.findings:
            return Exit.REFUTED
        return Exit.ANSWERED if self.rows else Exit.VACUOUS

    def to_json(self) -> documents.WorstDocument:
        """The document of ``worst --json``."""
        return {
            "schema": SCHEMA,
            "exit_code": self.exit_code,
            "explorer": self.explorer,
            "lighthouse": self.lighthouse,
            "class": self.extent.map_class.value,
            "edges": self.extent.levels[-1],
            "transit": None,
            "schedules": self.schedules,
            "symmetry": None,
            "shard": "0/1",
            "gate": {"source": self.source, "agrees": self.agrees},
            "complete": self.complete,
            "rows": [row.to_json() for row in self.rows],
            "findings": [finding.to_json() for finding in self.findings],
        }


def worst_of_runs(
    explore: str | Callable[..., Any],
    extent: Extent,
    lighthouse: str | None,
    workers: int,
    listener: Listener,
) -> RunsReport:
    """The worst and best cost of any explorer over its runs, in the worlds of an extent.

    Raises:
        InputError: for an explorer or a lighthouse that is none.
    """
    limits = Limits(workers)
    subject = subject_of(explore, limits)
    _, rules = rules_for(subject, {"map_class": extent.map_class.value, "lighthouse": lighthouse})
    scope = Scope(extent, rules, "all" if subject.takes_choices else "one")
    search = _RunsSearch(subject, rules, scope, limits, listener)
    finished, complete = until_interrupted(search.levels())
    return RunsReport(
        subject.name,
        extent,
        rules.lighthouse,
        scope.schedules,
        source_for(extent.map_class).name,
        tuple(row for level in finished for row in level),
        tuple(search.findings),
        search.disagreement,
        complete,
        subject,
        rules,
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

    def levels(self) -> Iterator[list[RunsRow]]:
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

    def _level(self, level: int, ready: ReadyEngine) -> list[RunsRow]:
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
    ) -> RunsRow:
        world = world_at(most_expensive, self.rules)
        again = single_run(self.subject, world, self.rules, most_expensive.choices, self.limits)
        return RunsRow(
            edges,
            vertices,
            row.worlds,
            row.max_cost,
            best.get(vertices, row.max_cost),
            row.bound,
            counted,
            world,
            most_expensive.choices,
            again.outcome.cost if again.finding is None else None,
        )
