"""Smallest and largest costs over the schedules of Algorithm 1: the result of ``worst``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

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
    single_run,
    told_scope,
)
from allworlds.explorers import Subject
from allworlds.judging import AskedRules, Finding, Rules
from allworlds.maps import AskedClass
from allworlds.studies.worst.worst_request import WorstRequest
from allworlds.world import AskedLighthouse, World

SYMMETRY = (
    "one world for each start vertex: every choice of dart is tried, so the "
    "dart faced at the start and the bearing make no difference"
)


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
    tests: Annotated[Natural, about("different tests of false hypotheses")]
    wrong_tests: Annotated[Natural, about("tests that confirmed a false hypothesis")]
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


class WorstScope(Document, of=(AskedClass, AskedLighthouse, WorstRequest, AskedRules)):
    """The scope of a search for the worst case."""

    schedules: Annotated[Literal["all"], about("each was searched")]
    symmetry: Annotated[Text, about("why one world stands for every direction")]
    shard: WhichShard


class WorstReport(SweptReport):
    """Report of 'worst'.

    The worst and best costs of Algorithm 1, by size.

    ``disagreement`` says what disagrees beside the rows, if anything does; ``subject`` is who was
    run by the ``rules``.
    """

    exit_code: SweptExit = EXIT_CODE
    explorer: Annotated[Text, about("its name")] = computed(lambda r: r.subject.name)
    scope: Annotated[WorstScope, about("what was searched")] = computed(
        lambda r: told_scope(
            WorstScope,
            r.request,
            r.rules,
            schedules="all",
            symmetry=SYMMETRY,
            shard=str(r.portion),
        )
    )
    gate: ToldGate = GATE
    rows: Annotated[tuple[WorstRow, ...], about("one for each (edges, vertices), ascending")]
    findings: Annotated[tuple[Finding, ...], about("always empty: `wrong_tests` counts")] = ()
    subject: Aside[Subject]
    rules: Aside[Rules]
    disagreement: Aside[str] = ""

    @property
    @override
    def agrees(self) -> bool:
        return not self.disagreement and all(row.agrees for row in self.rows)

    @property
    @override
    def refuted(self) -> bool:
        return any(row.refutes for row in self.rows)

    def walks(self) -> Iterator[SingleRun]:
        """The runs that attain each row's worst cost, where they are known, played again."""
        for row in self.rows:
            if row.replayed is not None:
                yield single_run(self.subject, row.world, self.rules, row.choices, Limits())
