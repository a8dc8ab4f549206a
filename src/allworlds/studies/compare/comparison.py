"""What a comparison of explorers has shown: rows, the world that parts them most, findings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from allworlds.engines import Limits, SingleRun, single_run
from allworlds.judging import Finding
from allworlds.maps import CombinatorialMap, Extent
from allworlds.outcome import SCHEMA, Exit, Verdict
from allworlds.studies.check import Completed, Ending, GateCell, Interrupted, Stopped
from allworlds.studies.compare.contestants import Contestant
from allworlds.world import World

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class InMap:
    """What an explorer costs in one rooted map, over the places of its lighthouse."""

    runs: int
    total: int
    worst: int

    @property
    def mean(self) -> Fraction:
        """Traversals a run."""
        return Fraction(self.total, self.runs)


@dataclass(frozen=True, slots=True)
class ComparedRow:
    """The worlds of one size.

    Attributes:
        edges, vertices: the size.
        worlds: rooted maps in which every explorer has a place.
        runs: of all explorers together.
        mean: for each explorer the mean over these maps.
        worst: for each explorer the largest cost of a run.
        less, equal, more: in how many maps the first explorer's mean is less than that of each
            other one, equal to it, or more.
    """

    edges: int
    vertices: int
    worlds: int
    runs: int
    mean: Mapping[str, Fraction]
    worst: Mapping[str, int]
    less: Mapping[str, int]
    equal: Mapping[str, int]
    more: Mapping[str, int]

    def ratio(self, name: str) -> Fraction | None:
        """The mean of an explorer, divided by that of the first; None where that is 0."""
        first = next(iter(self.mean.values()))
        return self.mean[name] / first if first else None

    def to_json(self) -> documents.CompareRow:
        """One row of the document."""
        ratios = {name: self.ratio(name) for name in self.mean}
        return {
            "edges": self.edges,
            "vertices": self.vertices,
            "worlds": self.worlds,
            "runs": self.runs,
            "mean": {name: rounded(mean) for name, mean in self.mean.items()},
            "worst": dict(self.worst),
            "ratio": {n: None if r is None else rounded(r) for n, r in ratios.items()},
            "less": dict(self.less),
            "equal": dict(self.equal),
            "more": dict(self.more),
        }


def rounded(value: Fraction) -> float:
    """As documents have it, with six digits behind the point."""
    return round(float(value), 6)


@dataclass(frozen=True, slots=True)
class DifferMost:
    """The smallest of the rooted maps in which the first explorer differs most from another.

    Attributes:
        map: rooted at dart 0.
        costs: for each explorer its mean there.
    """

    map: CombinatorialMap
    costs: Mapping[str, Fraction]

    @property
    def by(self) -> Fraction:
        """The largest difference."""
        first, *others = self.costs.values()
        return max(abs(other - first) for other in others)


@dataclass(frozen=True, slots=True)
class Comparison:
    """What a comparison has shown.

    Attributes:
        contestants: two or more.
        extent: the class of worlds; of a family it is not asked.
        family: how the one world was named; empty for a class.
        rows: of finished levels, ascending.
        differ_most: None where nothing was compared, or nothing differs.
        findings: the smallest of each explorer, in the level in which the comparison ended.
        limits: of the effort.
        ending: how it came to its end.
        gate: enumerated worlds beside those that an independent source counts.
    """

    contestants: tuple[Contestant, ...]
    extent: Extent
    family: str
    rows: tuple[ComparedRow, ...]
    differ_most: DifferMost | None
    findings: tuple[Finding, ...]
    limits: Limits
    ending: Ending
    gate: tuple[GateCell, ...] = ()

    @property
    def names(self) -> list[str]:
        """Those of the explorers."""
        return [contestant.name for contestant in self.contestants]

    @property
    def complete(self) -> bool:
        """Nothing was left undone."""
        return isinstance(self.ending, Completed)

    @property
    def verdict(self) -> Verdict:
        """About all explorers: whether a run of any broke a law."""
        if not all(cell.agrees for cell in self.gate):
            return Verdict.ERROR
        if self.findings:
            return Verdict.REFUTED
        if not self.complete:
            return Verdict.INCONCLUSIVE
        return Verdict.HOLDS if self.rows else Verdict.VACUOUS

    @property
    def exit_code(self) -> Exit:
        """That of the verdict; 130 where it was interrupted, whatever was found till then."""
        if isinstance(self.ending, Interrupted) and self.verdict is not Verdict.ERROR:
            return Exit.INTERRUPTED
        return self.verdict.exit

    def walks(self) -> Iterator[SingleRun]:
        """A run of each explorer in the world that differs most, at the first place."""
        if self.differ_most is None:
            return
        for contestant in self.contestants:
            world = self._world(self.differ_most, contestant)
            yield single_run(contestant.subject, world, contestant.rules, (), self.limits)

    @staticmethod
    def _world(most: DifferMost, contestant: Contestant) -> World:
        """The map that differs most, with an explorer's lighthouse at its first place."""
        return World(most.map, next(iter(contestant.rules.kind.places(most.map, 0))), 0)

    def to_json(self) -> documents.CompareDocument:
        """The document of ``compare --json``."""
        most = self.differ_most
        return {
            "schema": SCHEMA,
            "verdict": self.verdict.value,
            "exit_code": self.exit_code,
            "complete": self.complete,
            "explorers": [
                {
                    "name": contestant.name,
                    "lighthouse": contestant.rules.lighthouse,
                    "policy": contestant.rules.policy,
                    "bound": contestant.rules.the_bound.name,
                }
                for contestant in self.contestants
            ],
            "family": self.family or None,
            "class": self.extent.map_class.value,
            "edges": None if self.family else self.extent.edges,
            "vertices": None if self.family else self.extent.vertices,
            "rows": [row.to_json() for row in self.rows],
            "differ_most": None
            if most is None
            else {
                "world": self._world(most, self.contestants[0]).to_json(),
                "costs": {name: rounded(cost) for name, cost in most.costs.items()},
            },
            "stopped": self.ending.reason if isinstance(self.ending, Stopped) else None,
            "findings": [finding.to_json() for finding in self.findings],
        }


def row_of(edges: int, vertices: int, maps: Sequence[Mapping[str, InMap]]) -> ComparedRow:
    """The row of rooted maps of one size, each with what every explorer costs there."""
    first, *others = maps[0]

    def times(holds: Callable[[Fraction, Fraction], bool]) -> dict[str, int]:
        return {
            name: sum(holds(costs[first].mean, costs[name].mean) for costs in maps)
            for name in others
        }

    return ComparedRow(
        edges,
        vertices,
        len(maps),
        sum(cost.runs for costs in maps for cost in costs.values()),
        {n: sum((costs[n].mean for costs in maps), Fraction(0)) / len(maps) for n in maps[0]},
        {n: max(costs[n].worst for costs in maps) for n in maps[0]},
        times(lambda a, b: a < b),
        times(lambda a, b: a == b),
        times(lambda a, b: a > b),
    )
