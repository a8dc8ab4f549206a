"""The worst of any explorer: every run is played, under every schedule where it takes choices."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from allworlds.checker import SingleRun, rules_for, single_run
from allworlds.findings import Finding, Rules
from allworlds.isolation import confirmed, subject_of, workers_for
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.counting import source_for
from allworlds.outcome import SCHEMA, Exit, until_interrupted
from allworlds.progress import Listener
from allworlds.runs import Costing, CostTally, MapKey, RunCost, Schedule, Scope, Tally
from allworlds.subjects import Subject
from allworlds.work import Limits, Transport, cells_of_level, gather
from allworlds.world import World

if TYPE_CHECKING:
    from allworlds import documents


PLAYED = (
    "compiled code tries every schedule of algorithm1 alone; this library is played by the python "
    "engine, far slower"
)
"""The notice for explorers that ``check`` judges in compiled code."""


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

    def to_json(self) -> documents.WorstRow:
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
    complete: bool
    subject: Subject = field(compare=False)
    rules: Rules = field(compare=False)

    def walks(self) -> Iterator[SingleRun]:
        """The runs that attain each row's worst cost, played again."""
        for row in self.rows:
            yield single_run(self.subject, row.world, self.rules, row.choices, Limits())

    @property
    def agrees(self) -> bool:
        """Counts and replays agree with what was played."""
        return bool(self.findings) or all(row.agrees for row in self.rows)

    @property
    def exit_code(self) -> Exit:
        """0 answered, 1 refuted, 4 no run, 70 a count or a replay disagrees, 130 interrupted."""
        if not self.agrees:
            return Exit.DISAGREES
        if not self.complete:
            return Exit.INTERRUPTED
        if self.findings:
            return Exit.REFUTED
        return Exit.ANSWERED if self.rows else Exit.VACUOUS

    def to_json(self) -> documents.WorstReport:
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
    if subject.compiled:
        listener.notice(PLAYED)
    search = _Search(subject, rules, scope, limits, listener)
    finished, complete = until_interrupted(search.levels())
    return RunsReport(
        subject.name,
        extent,
        rules.lighthouse,
        scope.schedules,
        source_for(extent.map_class).name,
        tuple(row for level in finished for row in level),
        tuple(search.findings),
        complete,
        subject,
        rules,
    )


@dataclass(slots=True)
class _Dearest(Tally):
    """A tally with the dearest run of each number of vertices, in place of every run's cost."""

    worst: dict[int, tuple[RunCost, MapKey, int]] = field(default_factory=dict)
    best: dict[int, int] = field(default_factory=dict)

    def add(self, other: Tally) -> None:
        """Take in another part."""
        assert isinstance(other, CostTally)
        Tally.add(self, other)
        for (key, place), cost in other.costs.items():
            vertices, found = key[1], (cost, key, place)
            self.best[vertices] = max(self.best.get(vertices, 0), cost.cheapest)
            self.worst[vertices] = min(self.worst.get(vertices, found), found, key=_from_the_worst)


def _from_the_worst(found: tuple[RunCost, MapKey, int]) -> tuple[int, MapKey, int]:
    cost, key, place = found
    return -cost.dearest, key, place


@dataclass(slots=True)
class _Search:
    """On its way."""

    subject: Subject
    rules: Rules
    scope: Scope
    limits: Limits
    listener: Listener
    findings: list[Finding] = field(default_factory=list)

    def levels(self) -> Iterator[list[RunsRow]]:
        """The rows of each level; one with a finding is the last."""
        with workers_for(self.subject, self.limits) as transport:
            for level in self.scope.extent.levels:
                yield self._level(level, transport)
                if self.findings:
                    return

    def _level(self, level: int, transport: Transport[Any]) -> list[RunsRow]:
        cells = cells_of_level(self.scope.extent, level)
        self.listener.level(level, sum(cells.values()))
        found = _Dearest(keep=1)
        gather(transport, Costing(self.scope, 1), self.scope.units(level), found, self.listener)
        self.findings += [
            confirmed(finding, self.subject, self.limits, self.scope.schedules)
            for finding in found.findings
        ]
        return [
            self._row(level, vertices, found, cells.get(vertices, 0))
            for vertices in sorted(found.worst)
        ]

    def _row(self, edges: int, vertices: int, found: _Dearest, counted: int) -> RunsRow:
        cost, key, place = found.worst[vertices]
        map_ = CombinatorialMap(key[2], key[3])
        lighthouse = [*self.rules.kind.places(map_, 0)][place]
        world = World(map_, lighthouse, 0)
        again = single_run(self.subject, world, self.rules, cost.choices, self.limits)
        row = found.row(edges, vertices)
        return RunsRow(
            edges,
            vertices,
            row.worlds,
            cost.dearest,
            found.best[vertices],
            row.bound,
            counted,
            world,
            cost.choices,
            again.outcome.cost if again.finding is None else None,
        )
