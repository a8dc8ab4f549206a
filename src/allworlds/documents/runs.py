"""What is written about run directories."""

from typing import Annotated, Literal, NotRequired, TypeAlias, TypedDict

from allworlds.documents.checks import CheckDocument, MutantsDocument
from allworlds.documents.claims import ClaimsDocument
from allworlds.documents.common import MadeBy, ReportDocument
from allworlds.documents.comparisons import FigureDocument
from allworlds.documents.findings import FindingDocument
from allworlds.documents.questions import (
    AmbiguityCensusDocument,
    BenchDocument,
    SearchDocument,
)
from allworlds.documents.vocabulary import (
    EngineName,
    Figure,
    Natural,
    OfShard,
    Positive,
    Seconds,
    Text,
    Version,
)

MergeDocument: TypeAlias = CheckDocument | AmbiguityCensusDocument
"""What 'merge' writes: the report of the verb whose shards were joined."""


class GuessOfTime(TypedDict):
    """How long a check with so many edges will take."""

    edges: Annotated[Positive, "of the largest worlds"]
    engine: Annotated[EngineName, "which would do it"]
    worlds: Annotated[Natural, "rooted maps that are to be tried"]
    sampled: Annotated[
        Natural, "rooted maps of the last level that were tried for this; 0: the rate is a guess"
    ]
    rate: Annotated[Figure | None, "of these a second; null: none was finished in time"]
    seconds: Annotated[Seconds | None, "for all: a guess; null where there is no rate"]


class EstimateResult(GuessOfTime):
    """Estimate.

    How long a check will take: what `check --estimate` writes.
    """

    schema: Version
    made_by: NotRequired[Annotated[MadeBy, "in Python; always there on the command line"]]
    explorer: Annotated[Text, "its name"]
    larger: Annotated[list[GuessOfTime], "the same check with more edges"]


Watched: TypeAlias = (
    CheckDocument
    | AmbiguityCensusDocument
    | FigureDocument
    | MutantsDocument
    | SearchDocument
    | BenchDocument
    | ClaimsDocument
    | EstimateResult
)
"""What a verb with `--events` may report."""


class DoneOf(TypedDict):
    """How many of how many."""

    done: Annotated[Natural, "are finished"]
    all: Annotated[Natural, "are to be done"]


class MostExpensiveSoFar(TypedDict):
    """The largest cost so far."""

    edges: Positive
    vertices: Positive
    cost: Annotated[Natural, "traversals"]


class StatusDocument(ReportDocument):
    """Report of 'status'."""

    verb: Annotated[Text, "whose units these are"]
    version: Annotated[Text, "of the program that does them"]
    explorer: Annotated[str, "its name; empty where there is none"]
    shard: Annotated[str, OfShard, "`K/N`; `0/1` is the whole"]
    parameters: Annotated[dict[str, object], "what else the result depends on"]
    state: Annotated[
        Literal["running", "finished", "unfinished"],
        "whether somebody adds to it now; if nobody does, whether anything is left to add",
    ]
    units: Annotated[DoneOf, "pieces of work"]
    worlds: Annotated[DoneOf, "rooted maps; of a shard `all` is about its part"]
    rate: Annotated[
        Figure | None, "worlds a second since somebody last began; null: none yet, or all are"
    ]
    left_s: Annotated[
        Seconds | None, "until the end at this rate: a guess; null where there is no rate"
    ]
    worst: Annotated[MostExpensiveSoFar | None, "the largest cost so far; null: there is none"]
    findings: Annotated[Natural, "in the finished units"]


class LevelEvent(TypedDict):
    """A level begins."""

    schema: Version
    event: Literal["level"]
    edges: Positive
    worlds: Annotated[Natural, "rooted maps; of a shard about so many"]


class StageEvent(TypedDict):
    """A part of another kind begins."""

    schema: Version
    event: Literal["stage"]
    name: Annotated[Text, "of the part"]
    all: Annotated[Natural, "how many are to be done"]
    of: Annotated[Text, "what is counted"]


class ProgressEvent(TypedDict):
    """Once a second: what is done of the level or stage that began last."""

    schema: Version
    event: Literal["progress"]
    done: Annotated[Natural, "worlds, or what the stage counts"]


class UnitEvent(TypedDict):
    """A unit is finished."""

    schema: Version
    event: Literal["unit"]
    unit: Annotated[Text, "its key, `EDGES:DECISION,...`"]
    worlds: Annotated[Natural, "rooted maps"]


class FindingEvent(TypedDict):
    """A run that refutes was met in a unit that is finished."""

    schema: Version
    event: Literal["finding"]
    finding: Annotated[FindingDocument, "not confirmed yet; the report may hold a smaller one"]


class NoticeEvent(TypedDict):
    """Something that the user may want to know."""

    schema: Version
    event: Literal["notice"]
    text: Annotated[Text, "what stands on stderr too"]


class VerdictEvent(TypedDict):
    """The end."""

    schema: Version
    event: Literal["verdict"]
    report: Annotated[Watched, "the whole report, as `--json` prints it, without `made_by`"]


Event: TypeAlias = (
    LevelEvent | StageEvent | ProgressEvent | UnitEvent | FindingEvent | NoticeEvent | VerdictEvent
)
"""One line of what `--events FILE` writes."""
