"""What is written about runs: one explorer in every world, in one, or in one again."""

from typing import Annotated, Literal, NotRequired, TypeAlias, TypedDict

from allworlds.documents.common import ExtentDocument, ReportDocument
from allworlds.documents.findings import FindingDocument, Options
from allworlds.documents.vocabulary import (
    Dart,
    Different,
    EngineName,
    JudgedLaw,
    Keywords,
    LawName,
    Natural,
    OfShard,
    Positive,
    Some,
    Text,
    VerdictName,
    code,
)
from allworlds.documents.worlds import Rooted, RootedQuotient, Transcript, WorldDocument
from allworlds.outcome import Exit


class SampleDocument(TypedDict):
    """How random worlds were drawn."""

    edges: Annotated[Positive, "at most so many"]
    min_edges: Annotated[Positive, "at least so many"]
    runs: Annotated[Positive, "how many worlds were drawn"]
    seed: Annotated[int, "from which"]


class GateCell(TypedDict):
    """One comparison of the count gate."""

    edges: Positive
    vertices: Positive
    enumerated: Annotated[Natural, "rooted maps that were visited"]
    counted: Annotated[Natural, "those that there are"]
    source: Annotated[Text, "says who"]


Checked: TypeAlias = list[GateCell] | Literal["absent", "deferred to the merge of all shards"]
"""What has become of the count gate."""


class ScopeDocument(ExtentDocument):
    """What a check is about: every option that its counts and its verdict depend on."""

    lighthouse: Annotated[Text, "`KIND[:key=value,...]`"]
    policy: Annotated[Text, "who answered the explorer's choices"]
    schedules: Annotated[Literal["one", "all"], "the policy's, or every sequence of choices"]
    laws: Annotated[list[JudgedLaw], Different, "those that were checked"]
    bound: Annotated[Text, "the bound on the traversals; `none` where the law was not checked"]
    step_budget: Annotated[Positive | None, "the largest legal number of traversals; null: default"]
    shard: Annotated[str, OfShard, "`K/N`; `0/1` is the whole"]
    sample: Annotated[SampleDocument | None, "of `fuzz`: how the worlds were drawn"]
    symmetry: Annotated[str | None, "why one run was counted for several, where it was"]
    gate: Annotated[
        Checked,
        "the count gate: one comparison for each (edges, vertices) of the finished levels",
    ]
    complete: Annotated[bool, "every world of the scope was tried"]
    finished_levels: Annotated[list[Positive], Different, "the numbers of edges that are done"]
    stopped: Annotated[str | None, "why it is not complete; null: it is, or it is a sample"]


class CheckRow(TypedDict):
    """What was seen in the worlds of one size."""

    edges: Positive
    vertices: Positive
    worlds: Annotated[Natural, "rooted maps"]
    runs: Annotated[Natural, "worlds x places of the lighthouse"]
    episodes: Annotated[Natural, "runs x schedules"]
    traversals: Annotated[Natural, "summed over the episodes"]
    traversals_rooted: Annotated[Natural, "the same at the first place of each rooted map alone"]
    max_cost: Annotated[Natural, "the largest cost of an episode"]
    bound: Annotated[int | None, "the largest bound of a run; null without a bound"]


class CorpusDocument(TypedDict):
    """What became of the findings of a corpus."""

    directory: Annotated[Text, "where it is"]
    reproduced: Annotated[list[Text], "the files whose findings still stand"]
    beyond_scope: Annotated[
        list[Text],
        "of these the ones that this check could not have come upon; they refute nothing",
    ]
    fixed: Annotated[list[Text], "those whose worlds are no longer refuting; they are kept"]
    written: Annotated[list[Text], "those that this check has added"]


class CheckDocument(ReportDocument):
    """Report of 'check' and of 'fuzz'."""

    verdict: Annotated[VerdictName, "about the scope, and nothing else"]
    exit_code: Annotated[
        int,
        code(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ]
    explorer: Annotated[Text, "its name"]
    engine: Annotated[EngineName, "whichever did it"]
    scope: Annotated[ScopeDocument, "what was checked"]
    worlds: Annotated[Natural, "rooted maps"]
    runs: Annotated[Natural, "worlds x places of the lighthouse"]
    episodes: Annotated[Natural, "runs x schedules"]
    left_out: Annotated[Natural, "worlds without a place for the lighthouse"]
    traversals: Annotated[Natural, "summed over the episodes"]
    checkpoints: Annotated[Natural, "how many were published"]
    rows: Annotated[list[CheckRow], "one for each (edges, vertices), ascending"]
    witnesses: Annotated[
        dict[str, Positive], "how often each [event](verdicts.md#witnesses) occurred"
    ]
    missing_witnesses: Annotated[
        list[Text], Different, "those that must have occurred and have not"
    ]
    remarks: Annotated[list[Text], "what happened to processes and refutes nothing, each said once"]
    corpus: Annotated[CorpusDocument | None, "null without `--corpus`"]
    findings: Annotated[
        list[FindingDocument], "ascending by (edges, vertices, canonical code, place, choices)"
    ]


class RunDocument(ReportDocument):
    """Report of 'run'."""

    verdict: Annotated[str, Keywords(enum=["holds", "refuted"]), "about this run alone"]
    exit_code: Annotated[int, code(Exit.HOLDS, Exit.REFUTED)]
    explorer: Annotated[Text, "its name"]
    world: Annotated[WorldDocument, "as it was given"]
    options: Annotated[Options, "how it was played and judged"]
    choices: Annotated[list[Natural], "the index taken at each choice"]
    cost: Annotated[Natural, "traversals"]
    bound: Annotated[int | None, "of the traversals; null without one"]
    estimate: Annotated[Rooted | None, "the answer; null where there is none"]
    ambiguous: NotRequired[
        Annotated[RootedQuotient, "the answer that names no map, where there is one"]
    ]
    transcript: Annotated[Transcript, "the log"]
    finding: Annotated[FindingDocument | None, "null: no law is broken"]


class ReplayDocument(ReportDocument):
    """Report of 'replay'."""

    outcome: Annotated[
        Literal["reproduced", "fixed"], "`reproduced`: a law is broken again; `fixed`: none is"
    ]
    exit_code: Annotated[int, code(Exit.ANSWERED, Exit.FIXED)]
    explorer: Annotated[Text, "the one that ran"]
    law: Annotated[LawName, "the recorded one"]
    law_now: Annotated[LawName | None, "the one that is broken now; null: none"]
    run: Annotated[RunDocument, "the run of today"]


class ExplainDocument(ReportDocument):
    """Report of 'explain'."""

    explorer: Annotated[str, "its name"]
    law: Annotated[LawName, "the broken one"]
    step: Annotated[
        Natural | None,
        "the first at which the walk in the world and the same walk in the answer part; 0 is the "
        "start, null: at none",
    ]
    sentences: Annotated[list[Text], Some, "in plain words"]
    world: Annotated[WorldDocument, "that of the finding"]
    robot: Annotated[Dart, "where the robot is at the end"]
    answer: Annotated[Rooted | None, "the wrong answer; null where the finding holds none"]
    other: Annotated[
        WorldDocument | None,
        "under the law `folding` another world that agrees with the log; else null",
    ]
    slip: Annotated[
        Text | None,
        "the one thing that makes all the difference between answer and world, such as "
        "`mirror image`; null: none that is known",
    ]
