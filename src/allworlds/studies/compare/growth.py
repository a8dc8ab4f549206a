"""Costs in larger and larger worlds."""

from __future__ import annotations

from collections.abc import Iterator
from math import fsum
from typing import Annotated, TypeAlias

from typing_extensions import override

from allworlds.document.struct import (
    Aside,
    Document,
    Figure,
    Natural,
    Pair,
    Positive,
    Some,
    Text,
    about,
    computed,
)
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.outcome import Verdict
from allworlds.studies.compare.contest_report import ContestReport
from allworlds.studies.compare.contestants import InWorld
from allworlds.studies.compare.growing_families import member_named
from allworlds.studies.compare.intervals import (
    LEAST_WORLDS,
    LEVEL,
    Interval,
    geometric_mean,
    mean_interval,
)

Range: TypeAlias = Annotated[
    Pair[Figure] | None,
    about(
        f"by a bootstrap over the worlds, at {LEVEL:.0%}; null: exact, or fewer than "
        f"{LEAST_WORLDS} worlds"
    ),
]
"""An interval of a row."""


class GrownWorld(Document):
    """One world of a family, and an explorer's runs in it."""

    name: Annotated[Text, about("as `run --family` takes it")]
    edges: Annotated[Positive, about("of the map")]
    places: Annotated[Positive, about("places that the lighthouse has in this world")]
    ran: Annotated[Some[Natural], about("the numbers of those in which it was run")]
    costs: Annotated[Some[Natural], about("of these runs, in traversals")]
    bound: Annotated[int | None, about("the largest of these runs; null without a bound")]

    @property
    def mean(self) -> float:
        """The mean cost of the runs."""
        return sum(self.costs) / len(self.costs)

    def map(self) -> CombinatorialMap:
        """The map; the robot starts at dart 0."""
        return member_named(self.name).map()


class GrowRow(Document):
    """Costs of an explorer in the members of a family of one size."""

    family: Annotated[Text, about("as it was asked for")]
    edges: Annotated[Positive, about("of the first member")]
    vertices: Annotated[Positive, about("of the first member")]
    explorer: Annotated[Text, about("its name")]
    seeds: Annotated[Positive, about("members that were drawn; isomorphic ones count once")]
    drawn_from: Annotated[
        Positive | None,
        about("different rooted maps that seeds draw; null: they draw more than the start"),
    ]
    worlds: Annotated[Positive, about("different rooted maps among them")] = computed(
        lambda row: len(row.members)
    )
    places: Annotated[Positive, about("places of the lighthouse in these worlds")] = computed(
        lambda row: sum(one.places for one in row.members)
    )
    runs: Annotated[Positive, about("places in which it was run")] = computed(
        lambda row: sum(len(one.costs) for one in row.members)
    )
    mean: Annotated[
        Figure, about("traversals: over the worlds, in each over the places of its runs")
    ] = computed(lambda row: round(_mean(row), 6))
    exact: Annotated[bool, about("every world that seeds draw was run, in every place")]
    interval: Annotated[Range, about("of the mean")] = computed(
        lambda row: None if row.exact else _rounded(mean_interval(row.means))
    )
    least: Annotated[Natural, about("traversals of a run")] = computed(
        lambda row: min(min(one.costs) for one in row.members)
    )
    worst: Annotated[
        Natural, about("the most traversals of a run; of all, if `runs` = `places`")
    ] = computed(lambda row: max(max(one.costs) for one in row.members))
    bound: Annotated[int | None, about("the largest of a run; null without a bound")] = computed(
        lambda row: max((m.bound for m in row.members if m.bound is not None), default=None)
    )
    members: Annotated[Some[GrownWorld], about("the worlds, by seed")]

    @property
    def means(self) -> list[float]:
        """The mean cost in each world."""
        return [one.mean for one in self.members]


class CostRatio(Document):
    """Costs of an explorer divided by those of the first one, in the same worlds."""

    family: Annotated[Text, about("as it was asked for")]
    edges: Annotated[Positive, about("of the first member")]
    explorer: Annotated[Text, about("its name")]
    worlds: Annotated[Positive, about("in which both were run")]
    ratio: Annotated[Figure, about("the geometric mean of the ratios in these worlds")]
    exact: Annotated[bool, about("in every world that seeds draw, in every place")]
    interval: Annotated[Range, about("of the ratio")]


class Growth(ContestReport):
    """Report of 'compare --to'.

    Explorers in worlds that grow.

    ``begun`` holds the worlds that were finished of a size that was not, for rows for programs.
    """

    rows: Annotated[tuple[GrowRow, ...], about("one for each family, size and explorer")]
    ratios: Annotated[
        tuple[CostRatio, ...], about("one for each family, size and explorer but the first")
    ] = computed(lambda report: tuple(_ratios(report)))
    left_out: Annotated[Natural, about("members in which a lighthouse had no place")] = 0
    families: Aside[tuple[str, ...]]
    begun: Aside[tuple[GrowRow, ...]] = ()

    @property
    @override
    def judged(self) -> Verdict:
        return self.facts.sample_verdict

    def in_worlds(self) -> Iterator[InWorld]:
        """The runs in each world, row by row; those of a size that was not finished come last.

        Cost: each world is built once again.
        """
        every = *self.rows, *self.begun
        named = {one.name: one for row in every for one in row.members}
        built = {name: one.map() for name, one in named.items()}
        for number, row in enumerate(every):
            for one in row.members:
                costs = dict(zip(one.ran, one.costs, strict=True))
                map_, finished = built[one.name], number < len(self.rows)
                told = costs, one.places, one.bound, row.drawn_from, finished
                yield InWorld(map_, one.name, row.explorer, *told)


def _ratios(report: Growth) -> Iterator[CostRatio]:
    first = {(r.family, r.edges): r for r in report.rows if r.explorer == report.names[0]}
    for row in report.rows:
        beside = first.get((row.family, row.edges))
        if beside is None or beside is row:
            continue
        costs = {one.name: one.mean for one in beside.members}
        ratios = [one.mean / costs[one.name] for one in row.members if costs.get(one.name)]
        if ratios and (mean := geometric_mean(ratios)) is not None:
            exact = row.exact and beside.exact and len(ratios) == len(row.members) == len(costs)
            yield CostRatio(
                family=row.family,
                edges=row.edges,
                explorer=row.explorer,
                worlds=len(ratios),
                ratio=round(mean[0], 6),
                exact=exact,
                interval=None if exact else _rounded(mean[1]),
            )


def _mean(row: GrowRow) -> float:
    return fsum(row.means) / len(row.members)


def _rounded(interval: Interval | None) -> Interval | None:
    return interval and (round(interval[0], 6), round(interval[1], 6))
