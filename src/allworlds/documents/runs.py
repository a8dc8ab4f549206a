"""What is written about run directories."""

from typing import Annotated, Literal, TypeAlias, TypedDict

from allworlds.documents.checks import CheckReport
from allworlds.documents.common import Report
from allworlds.documents.questions import AmbiguityCensusReport, WorstReport
from allworlds.documents.words import Figure, Natural, OfShard, Positive, Seconds, Text

MergeReport: TypeAlias = CheckReport | WorstReport | AmbiguityCensusReport
"""What 'merge' writes: the report of the verb whose shards were joined."""


class DoneOf(TypedDict):
    """How many of how many."""

    done: Annotated[Natural, "are finished"]
    all: Annotated[Natural, "are to be done"]


class DearestSoFar(TypedDict):
    """The largest cost so far."""

    edges: Positive
    vertices: Positive
    cost: Annotated[Natural, "traversals"]


class StatusReport(Report):
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
    worst: Annotated[DearestSoFar | None, "the largest cost so far; null: there is none"]
    findings: Annotated[Natural, "in the finished units"]
