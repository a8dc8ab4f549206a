"""What the schedules of an explorer cost at most and at least, by size: the result of ``worst``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from allworlds.document import (
    AllRows,
    Aside,
    Document,
    Gate,
    Natural,
    Positive,
    Report,
    Text,
    WhichShard,
    about,
    computed,
    key,
    one_of,
)
from allworlds.engines import WHOLE, Limits, SingleRun, single_run
from allworlds.explorers import Subject
from allworlds.judging import Finding, Rules
from allworlds.maps import MapClass
from allworlds.outcome import Exit
from allworlds.protocol import Schedule
from allworlds.studies.worst.every_schedule import Transit
from allworlds.world import World


class WorstRow(Document):
    """What every schedule can cost in the worlds of one size.

    ``counted`` holds the rooted maps according to the independent source; None in a shard.
    """

    edges: Positive
    vertices: Positive
    worlds: Annotated[Positive, about("rooted maps")]
    worst: Annotated[Natural, about("the largest cost of a schedule")]
    best: Annotated[
        Natural, about("the largest, over the worlds, of the cost of the cheapest schedule")
    ]
    bound: Annotated[int | None, about("the largest of these worlds; null without a bound")]
    tests: Annotated[
        Natural | None, about("different tests of false hypotheses; null: not of Algorithm 1")
    ] = None
    wrong_tests: Annotated[
        Natural | None, about("those that confirmed one; null: not of Algorithm 1")
    ] = None
    world: Annotated[World, about("the least one that attains `worst`")]
    choices: Annotated[tuple[Natural, ...], about("that attain it there")]
    replayed: Annotated[
        Natural | None,
        about("what they cost in the Python engine; null: it did not keep every law"),
    ]
    counted: Aside[int | None]

    @property
    def agrees(self) -> bool:
        """The count and the replay say the same as what was searched."""
        counted = self.counted in (None, self.worlds)
        return counted and (bool(self.wrong_tests) or self.replayed == self.worst)

    @property
    def refutes(self) -> bool:
        """A test was wrong, or the bound was passed."""
        return bool(self.wrong_tests) or (self.bound is not None and self.worst > self.bound)


def _exit_code(report: WorstReport) -> Exit:
    """0 answered, 1 refuted, 4 no run, 70 engines or counts disagree, 130 interrupted."""
    if not _agrees(report):
        return Exit.DISAGREES
    if not report.complete:
        return Exit.INTERRUPTED
    if report.findings or any(row.refutes for row in report.rows):
        return Exit.REFUTED
    whole = report.shard == str(WHOLE)
    return Exit.VACUOUS if whole and not report.rows else Exit.ANSWERED


def _agrees(report: WorstReport) -> bool:
    if report.disagreement:
        return False
    return bool(report.findings) or all(row.agrees for row in report.rows)


class WorstReport(Report):
    """Report of 'worst'.

    The worst and best costs of an explorer, by size.

    ``source`` is that of the counts; ``disagreement`` says what disagrees beside the rows, if
    anything does; ``subject`` is who was run by the ``rules``.
    """

    exit_code: Annotated[
        Exit,
        one_of(Exit.ANSWERED, Exit.REFUTED, Exit.VACUOUS, Exit.DISAGREES, Exit.INTERRUPTED),
    ] = computed(_exit_code)
    explorer: Annotated[Text, about("its name")] = computed(lambda r: r.subject.name)
    lighthouse: Annotated[Text, about("`KIND[:key=value,...]`")] = computed(
        lambda r: r.rules.lighthouse
    )
    map_class: Annotated[MapClass, about("the class of maps")] = key(name="class")
    edges: Annotated[Positive, about("at most so many")]
    transit: Annotated[
        Transit | None,
        about("the paths by which Algorithm 1 goes to the next edge; null: another explorer"),
    ] = None
    schedules: Annotated[Schedule, about("one: the explorer takes no choices")]
    symmetry: Annotated[
        Text | None, about("why one world stands for every direction; null: each was tried")
    ] = None
    shard: WhichShard = str(WHOLE)
    gate: Annotated[
        Gate, about("counts, of a shard left to the merge, and replays in the Python engine")
    ] = computed(lambda r: Gate(source=r.source, agrees=_agrees(r)))
    complete: AllRows
    rows: Annotated[tuple[WorstRow, ...], about("one for each (edges, vertices), ascending")]
    findings: Annotated[
        tuple[Finding, ...], about("the smallest, if a run of another explorer broke a law")
    ] = ()
    source: Aside[str]
    disagreement: Aside[str] = ""
    subject: Aside[Subject]
    rules: Aside[Rules]

    def walks(self) -> Iterator[SingleRun]:
        """The runs that attain each row's worst cost, played again; of Algorithm 1 those known."""
        for row in self.rows:
            if self.transit is None or row.replayed is not None:
                yield single_run(self.subject, row.world, self.rules, row.choices, Limits())


def replayed_cost(
    subject: Subject, world: World, rules: Rules, choices: tuple[int, ...], limits: Limits
) -> int | None:
    """What the choices cost when they are taken again; None if a law is broken then."""
    again = single_run(subject, world, rules, choices, limits)
    return again.outcome.cost if again.finding is None else None
