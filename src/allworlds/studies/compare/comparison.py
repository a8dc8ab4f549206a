"""What a comparison of explorers has shown: rows, the world that parts them most, findings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Annotated

from allworlds.document import (
    AllRows,
    Aside,
    Document,
    Figure,
    Natural,
    Positive,
    Report,
    Some,
    Text,
    about,
    computed,
    key,
    one_of,
)
from allworlds.engines import Limits, SingleRun, single_run
from allworlds.judging import Finding
from allworlds.maps import MapClass
from allworlds.outcome import Exit, Verdict
from allworlds.studies.compare.contestants import Contestant
from allworlds.world import World


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


class Compared(Document):
    """An explorer of a comparison, and how it was run."""

    name: Annotated[Text, about("the explorer's")]
    lighthouse: Annotated[Text, about("`KIND[:key=value,...]`")]
    policy: Annotated[Text, about("who answered its choices")]
    bound: Annotated[
        Text, about("the bound on its traversals; `none` where the law was not checked")
    ]


def _compared(contestant: Contestant) -> Compared:
    rules = contestant.rules
    return Compared(
        name=contestant.name,
        lighthouse=rules.lighthouse,
        policy=rules.policy,
        bound=rules.the_bound.name,
    )


class ComparedRow(Document):
    """What explorers walk in the worlds of one size; the first is compared with each other one."""

    edges: Positive
    vertices: Positive
    worlds: Annotated[
        Positive, about("rooted maps in which every explorer's lighthouse has a place")
    ]
    runs: Annotated[Positive, about("judged in them, of all explorers together")]
    mean: Annotated[
        dict[str, Figure],
        about("for each explorer the mean over these maps of its mean over the places"),
    ]
    worst: Annotated[dict[str, Natural], about("for each explorer the largest cost of a run")]
    ratio: Annotated[
        dict[str, Figure | None],
        about("the mean divided by that of the first; null where that is 0"),
    ]
    less: Annotated[
        dict[str, Natural], about("in how many maps the first one's mean is less than this one's")
    ]
    equal: Annotated[dict[str, Natural], about("in how many it is equal")]
    more: Annotated[dict[str, Natural], about("in how many it is more")]


class DifferMost(Document):
    """The smallest of the worlds in which the first explorer differs most from another."""

    world: Annotated[World, about("the rooted map, with the first one's lighthouse")]
    costs: Annotated[dict[str, Figure], about("for each explorer its mean over the places")]


def _verdict(report: Comparison) -> Verdict:
    if not report.all_counted:
        return Verdict.ERROR
    if report.findings:
        return Verdict.REFUTED
    if not report.complete:
        return Verdict.INCONCLUSIVE
    return Verdict.HOLDS if report.rows else Verdict.VACUOUS


def _exit_code(report: Comparison) -> Exit:
    """That of the verdict; 130 where it was interrupted, whatever was found till then."""
    by_user = not report.complete and report.stopped is None
    if by_user and report.verdict is not Verdict.ERROR:
        return Exit.INTERRUPTED
    return report.verdict.exit


class Comparison(Report):
    """Report of 'compare'.

    Explorers side by side in the same worlds.

    ``all_counted`` tells that an independent source counts the worlds that were enumerated; the
    contestants were run under ``limits``.
    """

    verdict: Annotated[Verdict, about("whether a run of any explorer broke a law")] = computed(
        _verdict
    )
    exit_code: Annotated[
        Exit,
        one_of(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ] = computed(_exit_code)
    complete: AllRows
    explorers: Annotated[Some[Compared], about("in the order in which they were named")] = computed(
        lambda report: tuple(map(_compared, report.contestants))
    )
    family: Annotated[Text | None, about("the one world, with its seed; null: a class of worlds")]
    map_class: Annotated[MapClass, about("the class of maps")] = key(name="class")
    edges: Annotated[Positive | None, about("at most so many; null: not bounded, or a family")]
    vertices: Annotated[Positive | None, about("at most so many; null: not bounded, or a family")]
    rows: Annotated[
        tuple[ComparedRow, ...], about("one for each (edges, vertices) of the finished levels")
    ]
    differ_most: Annotated[
        DifferMost | None, about("null: nothing was compared, or nothing differs")
    ]
    stopped: Annotated[str | None, about("why it is not complete; null: it is, or by the user")]
    findings: Annotated[
        tuple[Finding, ...], about("the smallest of each explorer that broke a law")
    ]
    all_counted: Aside[bool]
    contestants: Aside[tuple[Contestant, ...]]
    limits: Aside[Limits]

    @property
    def names(self) -> list[str]:
        """Those of the explorers."""
        return [explorer.name for explorer in self.explorers]

    def walks(self) -> Iterator[SingleRun]:
        """A run of each explorer in the world that differs most, at the first place."""
        if self.differ_most is None:
            return
        for contestant in self.contestants:
            world = contestant.first_world(self.differ_most.world.map)
            yield single_run(contestant.subject, world, contestant.rules, (), self.limits)


def rounded(value: Fraction) -> float:
    """As documents have it, with six digits behind the point."""
    return round(float(value), 6)


def row_of(edges: int, vertices: int, maps: Sequence[Mapping[str, InMap]]) -> ComparedRow:
    """The row of rooted maps of one size, each with what every explorer costs there."""
    first, *others = maps[0]

    def times(holds: Callable[[Fraction, Fraction], bool]) -> dict[str, int]:
        return {
            name: sum(holds(costs[first].mean, costs[name].mean) for costs in maps)
            for name in others
        }

    mean = {n: sum((costs[n].mean for costs in maps), Fraction(0)) / len(maps) for n in maps[0]}
    return ComparedRow(
        edges=edges,
        vertices=vertices,
        worlds=len(maps),
        runs=sum(cost.runs for costs in maps for cost in costs.values()),
        mean={name: rounded(cost) for name, cost in mean.items()},
        worst={n: max(costs[n].worst for costs in maps) for n in maps[0]},
        ratio={n: rounded(cost / mean[first]) if mean[first] else None for n, cost in mean.items()},
        less=times(lambda a, b: a < b),
        equal=times(lambda a, b: a == b),
        more=times(lambda a, b: a > b),
    )
