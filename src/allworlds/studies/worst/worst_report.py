"""Smallest and largest costs over an explorer's schedules, by size: the result of ``worst``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from allworlds.document import (
    EXIT_CODE,
    AllRows,
    Aside,
    Document,
    Gate,
    IfAny,
    Natural,
    Positive,
    Report,
    Text,
    WhichShard,
    Why,
    about,
    computed,
    key,
    one_of,
)
from allworlds.engines import WHOLE, Limits, SingleRun, single_run
from allworlds.explorers import Subject
from allworlds.judging import Finding, Rules
from allworlds.maps import MapClass
from allworlds.outcome import Exit, Facts
from allworlds.protocol import Schedule
from allworlds.studies.worst.every_schedule import Transit
from allworlds.world import World


class WorstRow(Document):
    """Costs over every schedule in the worlds of one size.

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
        Natural | None, about("tests that confirmed a false hypothesis; null: not of Algorithm 1")
    ] = None
    world: Annotated[World, about("the least one that attains `worst`")]
    choices: Annotated[tuple[Natural, ...], about("choices that attain it there")]
    replayed: Annotated[
        Natural | None,
        about("their cost in the Python engine; null: a law was broken"),
    ]
    counted: Aside[int | None]

    @property
    def agrees(self) -> bool:
        """Whether count and replay agree with the search."""
        counted = self.counted in (None, self.worlds)
        return counted and (bool(self.wrong_tests) or self.replayed == self.worst)

    @property
    def refutes(self) -> bool:
        """Whether a test was wrong or the bound was exceeded."""
        return bool(self.wrong_tests) or (self.bound is not None and self.worst > self.bound)


class WorstReport(Report):
    """Report of 'worst'.

    The worst and best costs of an explorer, by size.

    ``source`` is that of the counts; ``disagreement`` says what disagrees beside the rows, if
    anything does; ``subject`` is who was run by the ``rules``.
    """

    exit_code: Annotated[
        Exit,
        one_of(
            *(Exit.ANSWERED, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.DISAGREES),
            Exit.INTERRUPTED,
        ),
    ] = EXIT_CODE
    explorer: Annotated[Text, about("its name")] = computed(lambda r: r.subject.name)
    lighthouse: Annotated[Text, about("`KIND[:key=value,...]`")] = computed(
        lambda r: str(r.rules.lighthouse)
    )
    map_class: Annotated[MapClass, about("the class of maps")] = key(name="class")
    edges: Annotated[Positive, about("at most so many")]
    where: Annotated[IfAny[Text | None], about("what besides is true of the maps")] = None
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
        Gate | None,
        about(
            "counts, of a shard left to the merge, and replays in the Python engine; null: no "
            "source counts these maps"
        ),
    ] = computed(lambda r: Gate(source=r.source, agrees=r.agrees) if r.source else None)
    complete: AllRows
    stopped: Why = None
    rows: Annotated[tuple[WorstRow, ...], about("one for each (edges, vertices), ascending")]
    findings: Annotated[
        tuple[Finding, ...], about("the smallest, if a run of another explorer broke a law")
    ] = ()
    source: Aside[str]
    disagreement: Aside[str] = ""
    subject: Aside[Subject]
    rules: Aside[Rules]

    @property
    def agrees(self) -> bool:
        """Whether counts, as far as there are any, and replays agree with the search."""
        if self.disagreement:
            return False
        return bool(self.findings) or all(row.agrees for row in self.rows)

    @property
    def facts(self) -> Facts:
        """Whether counts, replays and engines agree, and whether a schedule breaks a law."""
        return Facts.of_rows(
            self.complete,
            self.stopped,
            disagrees=not self.agrees,
            refuted=bool(self.findings) or any(row.refutes for row in self.rows),
            vacuous=self.shard == str(WHOLE) and not self.rows,
        )

    def walks(self) -> Iterator[SingleRun]:
        """The runs that attain each row's worst cost, played again; for Algorithm 1 those known."""
        for row in self.rows:
            if self.transit is None or row.replayed is not None:
                yield single_run(self.subject, row.world, self.rules, row.choices, Limits())


def replayed_cost(
    subject: Subject, world: World, rules: Rules, choices: tuple[int, ...], limits: Limits
) -> int | None:
    """The cost of the choices when they are taken again; None if a law is broken then."""
    again = single_run(subject, world, rules, choices, limits)
    return again.outcome.cost if again.finding is None else None
