"""Smallest and largest costs over an explorer's schedules, by size: the result of ``worst``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from typing_extensions import override

from allworlds.document import (
    EXIT_CODE,
    Aside,
    Document,
    Edges,
    Natural,
    Positive,
    Text,
    Vertices,
    WhichShard,
    about,
    computed,
)
from allworlds.engines import (
    GATE,
    Limits,
    SingleRun,
    SweptExit,
    SweptReport,
    ToldGate,
    TriedPlaces,
    single_run,
    told_scope,
    tried_places,
)
from allworlds.explorers import Subject
from allworlds.judging import AskedRules, Finding, Rules
from allworlds.protocol import Schedule
from allworlds.studies.check import SharedFile
from allworlds.studies.worst.every_schedule import Transit
from allworlds.studies.worst.worst_request import WorstRequest
from allworlds.world import World


class WorstRow(Document):
    """Costs over every schedule in the worlds of one size.

    ``counted`` holds the rooted maps according to the independent source; None in a shard.
    """

    edges: Edges
    vertices: Vertices
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


class WorstScope(Document, of=(WorstRequest, AskedRules)):
    """The scope of a search for the worst case."""

    places: TriedPlaces
    schedules: Annotated[Schedule, about("one: the explorer takes no choices")]
    symmetry: Annotated[
        Text | None, about("why one world stands for every direction; null: each was tried")
    ]
    shard: WhichShard
    shared_file: SharedFile


class WorstReport(SweptReport):
    """Report of 'worst'.

    The worst and best costs of an explorer, by size.

    ``disagreement`` says what disagrees beside the rows, if anything does; ``subject`` is who was
    run by the ``rules``, under which ``schedules``; ``transit`` are the paths by which Algorithm 1
    goes to the next edge, None of another explorer.
    """

    exit_code: SweptExit = EXIT_CODE
    explorer: Annotated[Text, about("its name")] = computed(lambda r: r.subject.name)
    scope: Annotated[WorstScope, about("what was searched")] = computed(
        lambda r: told_scope(
            WorstScope,
            r.request,
            r.rules,
            edges=r.extent.edges,
            transit=r.transit,
            places=tried_places(r.rules.lighthouse, r.extent),
            schedules=r.schedules,
            symmetry=r.symmetry,
            shard=str(r.portion),
            shared_file=r.rules.shared_file,
        )
    )
    gate: ToldGate = GATE
    rows: Annotated[tuple[WorstRow, ...], about("one for each (edges, vertices), ascending")]
    findings: Annotated[
        tuple[Finding, ...], about("the smallest, if a run of another explorer broke a law")
    ] = ()
    subject: Aside[Subject]
    rules: Aside[Rules]
    schedules: Aside[Schedule]
    transit: Aside[Transit | None] = None
    symmetry: Aside[str | None] = None
    disagreement: Aside[str] = ""

    @property
    @override
    def agrees(self) -> bool:
        if self.disagreement:
            return False
        return bool(self.findings) or all(row.agrees for row in self.rows)

    @property
    @override
    def refuted(self) -> bool:
        return bool(self.findings) or any(row.refutes for row in self.rows)

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
