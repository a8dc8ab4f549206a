"""The outcome of a check: a verdict that never comes without its scope."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal, TypeAlias, assert_never

from allworlds.document import (
    Aside,
    Bounded,
    Different,
    Document,
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
from allworlds.engines import EngineName, Sample, Scope, Shard, Tally, Whole
from allworlds.judging import Finding, JudgedLaw
from allworlds.maps import MapClass
from allworlds.outcome import Exit, Verdict
from allworlds.studies.check.ending import Completed, Disagreed, Ending, Interrupted, Stopped
from allworlds.studies.check.gate import GateCell
from allworlds.studies.check.known_findings import CorpusReport, UserCorpus


class SampleReport(Document):
    """How random worlds were drawn."""

    edges: Annotated[Positive, about("at most so many")]
    min_edges: Annotated[Positive, about("at least so many")]
    runs: Annotated[Positive, about("how many worlds were drawn")]
    seed: Annotated[int, about("from which")]


Gated: TypeAlias = tuple[GateCell, ...] | Literal["absent", "deferred to the merge of all shards"]
"""What has become of the count gate."""


class CheckedScope(Document):
    """The scope of a check: every option that its counts and its verdict depend on."""

    map_class: Annotated[MapClass, about("the class of maps")] = key(name="class")
    edges: Bounded
    vertices: Bounded
    lighthouse: Annotated[Text, about("`KIND[:key=value,...]`")]
    policy: Annotated[Text, about("who answered the explorer's choices")]
    schedules: Annotated[Literal["one", "all"], about("the policy's, or every sequence of choices")]
    laws: Annotated[Different[JudgedLaw], about("those that were checked")]
    bound: Annotated[
        Text, about("the bound on the traversals; `none` where the law was not checked")
    ]
    step_budget: Annotated[
        Positive | None, about("the largest legal number of traversals; null: default")
    ]
    shard: WhichShard
    sample: Annotated[SampleReport | None, about("of `fuzz`: how the worlds were drawn")]
    symmetry: Annotated[str | None, about("why one run was counted for several, where it was")]
    gate: Annotated[
        Gated,
        about("the count gate: one comparison for each (edges, vertices) of the finished levels"),
    ]
    complete: Annotated[bool, about("every world of the scope was tried")]
    finished_levels: Annotated[Different[Positive], about("the numbers of edges that are done")]
    stopped: Annotated[str | None, about("why it is not complete; null: it is, or it is a sample")]


class CheckRow(Document):
    """What was seen in the worlds of one size."""

    edges: Positive
    vertices: Positive
    worlds: Annotated[Natural, about("rooted maps")]
    runs: Annotated[Natural, about("worlds x places of the lighthouse")]
    episodes: Annotated[Natural, about("runs x schedules")]
    traversals: Annotated[Natural, about("summed over the episodes")]
    traversals_rooted: Annotated[
        Natural, about("the same at the first place of each rooted map alone")
    ]
    max_cost: Annotated[Natural, about("the largest cost of an episode")]
    bound: Annotated[int | None, about("the largest bound of a run; null without a bound")]


class CheckReport(Report):
    """Report of 'check' and of 'fuzz'.

    What a check has seen, and what follows from it.

    ``asked`` is what was to be checked, ``tally`` holds the counts of the finished levels and the
    smallest findings, ``ending`` tells how the check came to its end, ``cells`` are the
    comparisons of the count gate.
    """

    verdict: Annotated[Verdict, about("about the scope, and nothing else")] = computed(
        lambda report: report.judged()
    )
    exit_code: Annotated[
        Exit,
        one_of(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ] = computed(
        lambda report: (
            Exit.INTERRUPTED
            if report.interrupted and report.verdict is not Verdict.ERROR
            else report.verdict.exit
        )
    )
    explorer: Annotated[Text, about("its name")]
    engine: Annotated[EngineName, about("whichever did it")]
    scope: Annotated[CheckedScope, about("what was checked")] = computed(
        lambda report: report.checked_scope()
    )
    worlds: Annotated[Natural, about("rooted maps")] = computed(lambda report: report.tally.worlds)
    runs: Annotated[Natural, about("worlds x places of the lighthouse")] = computed(
        lambda report: report.tally.runs
    )
    episodes: Annotated[Natural, about("runs x schedules")] = computed(
        lambda report: sum(row.episodes for row in report.tally.rows.values())
    )
    left_out: Annotated[Natural, about("worlds without a place for the lighthouse")] = computed(
        lambda report: report.tally.left_out
    )
    traversals: Annotated[Natural, about("summed over the episodes")] = computed(
        lambda report: report.tally.traversals
    )
    checkpoints: Annotated[Natural, about("how many were published")] = computed(
        lambda report: report.tally.checkpoints
    )
    rows: Annotated[tuple[CheckRow, ...], about("one for each (edges, vertices), ascending")] = (
        computed(lambda report: tuple(_rows(report.tally)))
    )
    witnesses: Annotated[
        dict[str, Positive],
        about("how often each [event](verdicts.md#witnesses) occurred"),
    ] = computed(lambda report: dict(sorted(report.tally.witnesses.items())))
    missing_witnesses: Annotated[
        Different[Text], about("those that must have occurred and have not")
    ] = computed(
        lambda report: report.ending.missing if isinstance(report.ending, Completed) else ()
    )
    remarks: Annotated[
        tuple[Text, ...],
        about("what happened to processes and refutes nothing, each said once"),
    ] = computed(lambda report: tuple(_remarks(report.tally)))
    corpus: Annotated[CorpusReport | None, about("null without `--corpus`")] = computed(
        lambda report: report.past.report if report.past else None
    )
    findings: Annotated[
        tuple[Finding, ...],
        about("ascending by (edges, vertices, canonical code, place, choices)"),
    ] = computed(lambda report: tuple(report.tally.findings))
    asked: Aside[Scope]
    tally: Aside[Tally]
    levels: Aside[tuple[int, ...]]
    ending: Aside[Ending]
    cells: Aside[tuple[GateCell, ...]] = ()
    past: Aside[UserCorpus | None] = None
    symmetry: Aside[str] = ""

    @property
    def complete(self) -> bool:
        """Every world of the scope was tried; a sample is never complete."""
        return isinstance(self.ending, Completed) and not isinstance(self.asked.coverage, Sample)

    @property
    def ended(self) -> bool:
        """The same check again would do no more."""
        match self.ending:
            case Completed() | Disagreed():
                return True
            case Stopped(enough=enough):
                return enough
            case Interrupted():
                return False
            case ending:
                assert_never(ending)

    @property
    def interrupted(self) -> bool:
        """By the user."""
        return isinstance(self.ending, Interrupted)

    def judged(self) -> Verdict:
        """The verdict, about the scope and nothing else."""
        if isinstance(self.ending, Disagreed) or not all(cell.agrees for cell in self.cells):
            return Verdict.ERROR
        if self.tally.findings:
            return Verdict.REFUTED
        if not isinstance(self.ending, Completed):
            return Verdict.INCONCLUSIVE
        match self.asked.coverage:
            case Sample():
                return Verdict.NOT_REFUTED if self.tally.runs else Verdict.INCONCLUSIVE
            case Shard():
                return Verdict.HOLDS
            case Whole():
                vacuous = self.ending.missing or not self.tally.runs
                return Verdict.VACUOUS if vacuous else Verdict.HOLDS
            case coverage:
                assert_never(coverage)

    def uninterrupted(self) -> CheckReport:
        """This report, for callers to whom half a check says nothing.

        Raises:
            KeyboardInterrupt: if it was interrupted; ``check`` has kept that to itself.
        """
        if self.interrupted:
            raise KeyboardInterrupt
        return self

    def checked_scope(self) -> CheckedScope:
        """What was checked, and how much of it."""
        extent, rules, coverage = self.asked.extent, self.asked.rules, self.asked.coverage
        sample: SampleReport | None = None
        gate: Gated = self.cells
        match coverage:
            case Sample():
                gate = "absent"
                sample = SampleReport(
                    edges=extent.levels[-1],
                    min_edges=coverage.min_edges,
                    runs=coverage.runs,
                    seed=coverage.seed,
                )
            case Shard():
                gate = "deferred to the merge of all shards"
        return CheckedScope(
            map_class=extent.map_class,
            edges=extent.edges,
            vertices=extent.vertices,
            lighthouse=rules.lighthouse,
            policy=rules.policy,
            schedules=self.asked.schedules,
            laws=rules.applying,
            bound=rules.the_bound.name,
            step_budget=rules.step_budget,
            shard=str(coverage) if isinstance(coverage, Shard) else "0/1",
            sample=sample,
            symmetry=self.symmetry or None,
            gate=gate,
            complete=self.complete,
            finished_levels=self.levels,
            stopped=self.ending.reason or None,
        )


def _rows(tally: Tally) -> Iterator[CheckRow]:
    for (edges, vertices), row in sorted(tally.rows.items()):
        yield CheckRow(
            edges=edges,
            vertices=vertices,
            worlds=row.worlds,
            runs=row.runs,
            episodes=row.episodes,
            traversals=row.traversals,
            traversals_rooted=row.traversals_rooted,
            max_cost=row.max_cost,
            bound=row.bound,
        )


def _remarks(tally: Tally) -> Iterator[str]:
    for text, times in sorted(tally.remarks.items()):
        yield text if times == 1 else f"{text} ({times} times)"
