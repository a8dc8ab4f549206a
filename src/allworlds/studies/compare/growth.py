"""What larger and larger worlds have cost, and the exponents that are fitted to it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import log
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
    one_of,
)
from allworlds.judging import Finding
from allworlds.outcome import Exit, Verdict


class GrowRow(Document):
    """What an explorer walks in the members of a family of one size."""

    family: Annotated[Text, about("as it was asked for")]
    edges: Annotated[Positive, about("of each member")]
    vertices: Annotated[Positive, about("of the first member")]
    explorer: Annotated[Text, about("its name")]
    mean: Annotated[Figure, about("traversals")] = computed(lambda row: round(_mean(row), 6))
    least: Annotated[Natural, about("traversals")] = computed(lambda row: min(row.costs))
    worst: Annotated[Natural, about("traversals")] = computed(lambda row: max(row.costs))
    bound: Annotated[int | None, about("the largest bound of a run; null without a bound")]
    members: Annotated[Some[Text], about("the worlds, as `run --family` takes them")]
    costs: Annotated[Some[Natural], about("of the runs in them")]


class Exponent(Document):
    """How an explorer's cost grows in a family: like the edges to this power.

    The slopes are the same, not rounded.
    """

    family: Annotated[Text, about("as it was asked for")]
    explorer: Annotated[Text, about("its name")]
    exponent: Annotated[
        float, about("fitted to the means of all sizes, by least squares of logarithms")
    ] = computed(lambda one: round(one.slope, 3))
    last: Annotated[float, about("the same of the last two sizes")] = computed(
        lambda one: round(one.last_slope, 3)
    )
    slope: Aside[float]
    last_slope: Aside[float]


def _verdict(report: Growth) -> Verdict:
    if report.findings:
        return Verdict.REFUTED
    if not report.complete:
        return Verdict.INCONCLUSIVE
    return Verdict.NOT_REFUTED if report.rows else Verdict.VACUOUS


def _exit_code(report: Growth) -> Exit:
    """That of the verdict; 130 where it was interrupted, whatever was found till then."""
    by_user = not report.complete and report.stopped is None
    return Exit.INTERRUPTED if by_user else report.verdict.exit


class Growth(Report):
    """Report of 'compare --to'.

    Explorers in worlds that grow.
    """

    verdict: Annotated[Verdict, about("whether a run broke a law")] = computed(_verdict)
    exit_code: Annotated[
        Exit,
        one_of(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERRUPTED),
    ] = computed(_exit_code)
    complete: AllRows
    explorers: Annotated[Some[Text], about("in the order in which they were named")]
    families: Annotated[Some[Text], about("likewise")]
    rows: Annotated[tuple[GrowRow, ...], about("one for each family, size and explorer")]
    exponents: Annotated[
        tuple[Exponent, ...], about("one for each family and explorer with two sizes or more")
    ] = computed(lambda report: tuple(_exponents(report)))
    left_out: Annotated[Natural, about("members in which a lighthouse had no place")] = 0
    stopped: Annotated[str | None, about("why it is not complete; null: it is, or by the user")] = (
        None
    )
    findings: Annotated[
        tuple[Finding, ...], about("the smallest of each explorer in each family")
    ] = ()


def _exponents(report: Growth) -> Iterator[Exponent]:
    for family in report.families:
        for name in report.explorers:
            rows = [r for r in report.rows if (r.family, r.explorer) == (family, name)]
            if len(rows) > 1:
                yield Exponent(
                    family=family,
                    explorer=name,
                    slope=_slope(rows),
                    last_slope=_slope(rows[-2:]),
                )


def _mean(row: GrowRow) -> float:
    return sum(row.costs) / len(row.costs)


def _slope(rows: Sequence[GrowRow]) -> float:
    """Of the straight line through log mean over log edges, by least squares."""
    from numpy import polyfit

    points = [(log(row.edges), log(_mean(row))) for row in rows]
    slope, _ = polyfit([x for x, _ in points], [y for _, y in points], 1)
    return float(slope)
