"""Explorers side by side on the same worlds: the verb ``compare``.

Each explorer is run under its own lighthouse unless one is named, and every run is judged.  In a
rooted map an explorer's cost is the mean over the places of its lighthouse; a map in which one of
the explorers has no place is left out for all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import groupby
from typing import TYPE_CHECKING, Any, Unpack

from allworlds.checker import (
    Cell,
    ManyRunsOptions,
    SingleRun,
    count_gate,
    refuse_others,
    rules_for,
    single_run,
)
from allworlds.findings import Finding, Rules
from allworlds.inputs import InputError, show
from allworlds.isolation import Unsettled, confirmed, subject_of, workers_for
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.outcome import SCHEMA, Exit, Verdict
from allworlds.progress import Listener, Silent
from allworlds.runs import Costing, CostTally, GivenWorlds, MapKey, Scope, Worlds
from allworlds.subjects import Subject
from allworlds.work import Limits, TimeIsUp, Transport, gather, level_size
from allworlds.world import World, map_of_family

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class Contestant:
    """An explorer with the rules that its runs are judged by."""

    subject: Subject
    rules: Rules

    @property
    def name(self) -> str:
        """The explorer's."""
        return self.subject.name


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
        gate: enumerated worlds beside those that an independent source counts.
        stopped: why there is not more; empty if it is complete.
        interrupted: by the user.
    """

    contestants: tuple[Contestant, ...]
    extent: Extent
    family: str
    rows: tuple[ComparedRow, ...]
    differ_most: DifferMost | None
    findings: tuple[Finding, ...]
    limits: Limits
    gate: tuple[Cell, ...] = ()
    stopped: str = ""
    interrupted: bool = False

    @property
    def names(self) -> list[str]:
        """Those of the explorers."""
        return [contestant.name for contestant in self.contestants]

    @property
    def verdict(self) -> Verdict:
        """About all explorers: whether a run of any broke a law."""
        if not all(cell.agrees for cell in self.gate):
            return Verdict.ERROR
        if self.findings:
            return Verdict.REFUTED
        if self.stopped or self.interrupted:
            return Verdict.INCONCLUSIVE
        return Verdict.HOLDS if self.rows else Verdict.VACUOUS

    @property
    def exit_code(self) -> Exit:
        """Of the command."""
        if self.interrupted and self.verdict is Verdict.INCONCLUSIVE:
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

    def to_json(self) -> documents.CompareReport:
        """The document of ``compare --json``."""
        most = self.differ_most
        return {
            "schema": SCHEMA,
            "verdict": self.verdict.value,
            "exit_code": self.exit_code,
            "complete": not (self.stopped or self.interrupted),
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
            "stopped": self.stopped or None,
            "findings": [finding.to_json() for finding in self.findings],
        }


class CompareOptions(ManyRunsOptions, total=False):
    """What ``compare`` takes beside the options of many runs.

    Attributes:
        edges, vertices: the extent of the class.
        family: one world of a family, in place of a class.
        holes: the share of its edges to be removed.
        seed: for whatever is drawn of it.
    """

    edges: int | None
    vertices: int | None
    family: str | None
    holes: str | None
    seed: int


def compare(
    *explorers: str | Callable[..., Any],
    listener: Listener | None = None,
    **options: Unpack[CompareOptions],
) -> Comparison:
    """Run explorers in the same worlds, judge every run, and compare what they walk.

    Args:
        explorers: names (see :func:`allworlds.subjects.load`) or generator functions; two or more.
        listener: is told of the progress.
        options: the worlds, and how runs are judged; see :class:`CompareOptions`.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    refuse_others("compare", options, CompareOptions)
    limits = Limits.of(options)
    contestants = tuple(_contestant(explore, limits, options) for explore in explorers)
    names = [contestant.name for contestant in contestants]
    if len(names) < 2:
        raise InputError(f"compare takes two explorers at least, not {show(', '.join(names))}")
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"explorer {show(name)} is named twice")
    map_class, _ = rules_for(contestants[0].subject, options)
    heard = listener or Silent()
    family = options.get("family")
    edges, vertices = options.get("edges"), options.get("vertices")
    if family is not None:
        if edges is not None or vertices is not None:
            raise InputError(f"family {show(family)} is one world; it takes no edges or vertices")
        holes, seed = options.get("holes"), options.get("seed", 0)
        map_ = map_of_family(family, holes, seed)
        extent = Extent(map_class, map_.edge_count)
        text = f"{family}{f' with holes {holes}' if holes else ''}, seed {seed}"
        return _Contest(contestants, extent, limits, heard, text, map_).run()
    if options.get("holes") is not None:
        raise InputError(f"holes {options['holes']} has no effect without a family")
    if edges is None and vertices is None:
        raise InputError("compare takes edges, vertices or a family")
    return _Contest(contestants, Extent(map_class, edges, vertices), limits, heard).run()


def _contestant(
    explore: str | Callable[..., Any], limits: Limits, options: CompareOptions
) -> Contestant:
    subject = subject_of(explore, limits)
    return Contestant(subject, rules_for(subject, options)[1])


@dataclass(slots=True)
class _Contest:
    """A comparison on its way."""

    contestants: tuple[Contestant, ...]
    extent: Extent
    limits: Limits
    listener: Listener
    family: str = ""
    map: CombinatorialMap | None = None
    rows: list[ComparedRow] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    gate: list[Cell] = field(default_factory=list)
    most: DifferMost | None = None

    def run(self) -> Comparison:
        stopped, interrupted = "", False
        try:
            self._levels()
        except TimeIsUp:
            stopped = f"the time limit of {self.limits.time_limit:g} s was reached"
        except Unsettled as error:
            stopped = str(error)
        except KeyboardInterrupt:
            interrupted = True
        return Comparison(
            self.contestants,
            self.extent,
            self.family,
            tuple(self.rows),
            self.most if self.most and self.most.by else None,
            tuple(self.findings),
            self.limits,
            tuple(self.gate),
            stopped,
            interrupted,
        )

    def _levels(self) -> None:
        deadline = self.limits.deadline()
        with ExitStack() as stack:
            transports = [
                stack.enter_context(workers_for(one.subject, self.limits, deadline))
                for one in self.contestants
            ]
            levels = [self.extent.levels[-1]] if self.map else self.extent.levels
            for level in levels:
                if self.findings:
                    return
                self._level(level, transports)

    def _level(self, level: int, transports: Sequence[Transport[Any]]) -> None:
        size = 1 if self.map else level_size(self.extent, level)
        self.listener.level(level, size * len(self.contestants))
        costs = []
        for contestant, transport in zip(self.contestants, transports, strict=True):
            scope = Scope(self.extent, contestant.rules)
            tally = CostTally(keep=1)
            units = self._units(scope, level)
            gather(transport, Costing(scope, tally.keep), units, tally, self.listener)
            costs.append(in_maps(tally))
            if self.map is None and not any(cell.edges == level for cell in self.gate):
                self.gate += count_gate(self.extent, level, tally)
            self.findings += [
                confirmed(found, contestant.subject, self.limits, "one") for found in tally.findings
            ]
        self._compare(costs)

    def _units(self, scope: Scope, level: int) -> Iterable[Worlds]:
        if self.map is None:
            return scope.units(level)
        places = enumerate(scope.rules.kind.places(self.map, 0))
        given = tuple((World(self.map, lighthouse, 0), place) for place, lighthouse in places)
        return [GivenWorlds(given)] if given else []

    def _compare(self, costs: Sequence[Mapping[MapKey, InMap]]) -> None:
        names = [contestant.name for contestant in self.contestants]
        shared = sorted(set(costs[0]).intersection(*costs[1:]))
        for (edges, vertices), keys in groupby(shared, key=lambda key: key[:2]):
            maps = [{n: cost[key] for n, cost in zip(names, costs, strict=True)} for key in keys]
            self.rows.append(row_of(edges, vertices, maps))
        for key in shared:
            means = {n: cost[key].mean for n, cost in zip(names, costs, strict=True)}
            candidate = DifferMost(CombinatorialMap(key[2], key[3]), means)
            if self.most is None or candidate.by > self.most.by:
                self.most = candidate


def in_maps(tally: CostTally) -> dict[MapKey, InMap]:
    """What the runs of each rooted map cost together."""
    found: dict[MapKey, InMap] = {}
    for (key, _), cost in tally.costs.items():
        known = found.get(key, InMap(0, 0, 0))
        worst = max(known.worst, cost.dearest)
        found[key] = InMap(known.runs + 1, known.total + cost.dearest, worst)
    return found


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
