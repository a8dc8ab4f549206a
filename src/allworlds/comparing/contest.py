"""Explorers are run in the same worlds, level by level."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any, Unpack

from allworlds.checker import Cell, ManyRunsOptions, count_gate, ending_of, refuse_others, rules_for
from allworlds.comparing.comparison import ComparedRow, Comparison, DifferMost, InMap, row_of
from allworlds.contestants import Contestant, contestants_of
from allworlds.findings import Finding
from allworlds.inputs import InputError, show
from allworlds.isolation import workers_for
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.progress import Listener, Silent
from allworlds.runs import CostTally, GivenWorlds, MapKey, Worlds
from allworlds.work import Limits, Transport, level_size
from allworlds.world import World, map_of_family


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
    contestants = contestants_of(explorers, limits, options)
    if len(contestants) < 2:
        only = show(contestants[0].name) if contestants else "none"
        raise InputError(f"compare takes two explorers at least, not {only}")
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
        ending = ending_of(self._levels, self.limits)
        return Comparison(
            self.contestants,
            self.extent,
            self.family,
            tuple(self.rows),
            self.most if self.most and self.most.by else None,
            tuple(self.findings),
            self.limits,
            ending,
            tuple(self.gate),
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
            units = self._units(contestant, level)
            tally = contestant.costs(self.extent, units, transport, self.listener)
            costs.append(in_maps(tally))
            if self.map is None and not any(cell.edges == level for cell in self.gate):
                self.gate += count_gate(self.extent, level, tally)
            self.findings += contestant.confirmed(tally, self.limits)
        self._compare(costs)

    def _units(self, contestant: Contestant, level: int) -> Iterable[Worlds]:
        if self.map is None:
            return contestant.scope(self.extent).units(level)
        places = enumerate(contestant.rules.kind.places(self.map, 0))
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
