"""The outcome of a check: a verdict that never comes without its scope."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal, TypeAlias

from allworlds.document import (
    EXIT_CODE,
    Aside,
    Bounded,
    Different,
    Document,
    IfAny,
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
from allworlds.engines import GOES_BY_HASHES, EngineName, Given, Sample, Scope, Shard, Tally
from allworlds.explorers import files_of_explorer
from allworlds.judging import Finding, JudgedLaw
from allworlds.maps import MapClass, source_of
from allworlds.outcome import (
    Completed,
    Disagreed,
    Ending,
    Exit,
    Facts,
    Interrupted,
    Stopped,
    Verdict,
)
from allworlds.studies.check.gate import GateCell
from allworlds.studies.check.known_findings import CorpusReport, UserCorpus
from allworlds.world import files_of_condition


class SampleReport(Document):
    """How random worlds were drawn."""

    edges: Annotated[Positive, about("at most so many")]
    min_edges: Annotated[Positive, about("at least so many")]
    runs: Annotated[Positive, about("how many worlds were drawn")]
    seed: Annotated[int, about("from which")]


Gated: TypeAlias = tuple[GateCell, ...] | Literal["absent", "deferred to the merge of all shards"]
"""The state of the count gate."""


class CheckedScope(Document):
    """The scope of a check: every option that its counts and its verdict depend on."""

    map_class: Annotated[MapClass, about("the class of maps")] = key(name="class")
    edges: Bounded
    vertices: Bounded
    where: Annotated[IfAny[Text | None], about("what besides is true of the maps")]
    lighthouse: Annotated[Text, about("`KIND[:key=value,...]`")]
    task: Annotated[
        IfAny[Text | None], about("what counted as done; where it is left out, the map")
    ]
    shared_file: Annotated[
        IfAny[str], about("the explorer's file, where judges load code from it, too: see trust")
    ]
    policy: Annotated[Text, about("who answered the explorer's choices")]
    schedules: Annotated[Literal["one", "all"], about("the policy's, or every sequence of choices")]
    laws: Annotated[Different[JudgedLaw], about("the laws that were checked")]
    bound: Annotated[
        Text, about("the bound on the traversals; `none` where the law was not checked")
    ]
    step_budget: Annotated[
        Positive | None, about("the largest legal number of traversals; null: default")
    ]
    shard: WhichShard
    sample: Annotated[SampleReport | None, about("of `fuzz`: how the worlds were drawn")]
    given: Annotated[
        IfAny[Positive | None], about("how many worlds were given; where it is left out, none")
    ]
    symmetry: Annotated[str | None, about("why one run was counted for several, if it was")]
    gate: Annotated[
        Gated,
        about("the count gate: one comparison for each (edges, vertices) of the finished levels"),
    ]
    complete: Annotated[bool, about("whether every world of the scope was tried")]
    finished_levels: Annotated[Different[Positive], about("the finished numbers of edges")]
    stopped: Annotated[str | None, about("why it is not complete; null: it is, or it is a sample")]


class CheckRow(Document):
    """Counts and costs of the worlds of one size."""

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

    verdict: Annotated[Verdict, about("about this scope alone")] = computed(
        lambda report: report.judged
    )
    exit_code: Annotated[
        Exit,
        one_of(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ] = EXIT_CODE
    explorer: Annotated[Text, about("its name")]
    engine: Annotated[EngineName, about("the engine that ran")]
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
    checkpoints: Annotated[Natural, about("the number of checkpoints")] = computed(
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
        Different[Text], about("witnesses that must occur and did not")
    ] = computed(
        lambda report: report.ending.missing if isinstance(report.ending, Completed) else ()
    )
    remarks: Annotated[
        tuple[Text, ...],
        about("remarks about processes, which refute nothing, each once"),
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
        """Whether every world of the scope was tried. A sample is never complete."""
        return isinstance(self.ending, Completed) and not isinstance(self.asked.coverage, Sample)

    @property
    def interrupted(self) -> bool:
        """Whether the user interrupted the check."""
        return isinstance(self.ending, Interrupted)

    @property
    def facts(self) -> Facts:
        """The facts that decide the exit code and the verdict."""
        ending, coverage = self.ending, self.asked.coverage
        nothing = not self.tally.runs and not isinstance(self.asked.portion, Shard)
        empty_sample = isinstance(coverage, Sample) and nothing
        lacking = isinstance(ending, Completed) and bool(ending.missing)
        return Facts(
            disagrees=isinstance(ending, Disagreed) or not all(c.agrees for c in self.cells),
            interrupted=self.interrupted,
            refuted=bool(self.tally.findings),
            undecided=isinstance(ending, Stopped) or empty_sample,
            vacuous=nothing or lacking,
        )

    @property
    def judged(self) -> Verdict:
        """The verdict; for a sample it is never 'holds'."""
        sampled = isinstance(self.asked.coverage, Sample)
        return self.facts.sample_verdict if sampled else self.facts.verdict

    def uninterrupted(self) -> CheckReport:
        """This report, for callers that can do nothing with half a check.

        Raises:
            KeyboardInterrupt: if it was interrupted; ``check`` has kept that to itself.
        """
        if self.interrupted:
            raise KeyboardInterrupt
        return self

    def checked_scope(self) -> CheckedScope:
        """The scope of the check, and how much of it was done."""
        extent, rules, coverage = self.asked.extent, self.asked.rules, self.asked.coverage
        sample: SampleReport | None = None
        gate: Gated = self.cells
        if source_of(extent) is None:
            gate = "absent"
        match coverage:
            case Sample():
                gate = "absent"
                sample = SampleReport(
                    edges=extent.levels[-1],
                    min_edges=coverage.min_edges,
                    runs=coverage.runs,
                    seed=coverage.seed,
                )
            case Given():
                gate = "absent"
            case Shard() if source_of(extent) is not None:
                gate = "deferred to the merge of all shards"
        return CheckedScope(
            map_class=extent.map_class,
            edges=extent.edges,
            vertices=extent.vertices,
            where=extent.where.name if extent.where else None,
            lighthouse=str(rules.lighthouse),
            task=None if rules.task.is_map else rules.task.name,
            shared_file=shared_file(self.explorer, self.asked),
            policy=rules.policy,
            schedules=self.asked.schedules,
            laws=rules.applying,
            bound=rules.the_bound.name,
            step_budget=rules.step_budget,
            shard=str(self.asked.portion),
            sample=sample,
            given=len(coverage.worlds) if isinstance(coverage, Given) else None,
            symmetry=self.symmetry or None,
            gate=gate,
            complete=self.complete,
            finished_levels=self.levels,
            stopped=self.ending.reason or None,
        )


def shared_file(explorer: str, scope: Scope) -> str:
    """The name of the explorer's file where code that judges it stands there, too; else empty.

    Such code runs where verdicts are made, and could make one.
    """
    files = (*scope.rules.files, *files_of_condition(scope.extent.where))
    if not files:
        return ""
    theirs = {file.resolve() for file in files_of_explorer(explorer)}
    return next((file.name for file in files if file in theirs), "")


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
    more_than_hashes = any(found.law == "nondeterministic" for found in tally.findings)
    for text, times in sorted(tally.remarks.items()):
        if text != GOES_BY_HASHES:
            yield text if times == 1 else f"{text} ({times} times)"
        elif not more_than_hashes:
            yield text
