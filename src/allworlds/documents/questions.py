"""What is written about maps, worlds and engines; and the manifest of a corpus."""

from typing import Annotated, Literal, TypedDict

from allworlds.documents.common import Gate, InRows, OfClass
from allworlds.documents.findings import FindingDocument
from allworlds.documents.vocabulary import (
    Figure,
    Keywords,
    Natural,
    OfShard,
    Positive,
    Seconds,
    Some,
    Text,
    Version,
    code,
)
from allworlds.documents.worlds import PerceptDocument, Rooted, WorldDocument
from allworlds.outcome import Exit


class WorstRowDocument(TypedDict):
    """What every schedule can cost in the worlds of one size."""

    edges: Positive
    vertices: Positive
    worlds: Annotated[Positive, "rooted maps"]
    worst: Annotated[Natural, "the largest cost of a schedule"]
    best: Annotated[Natural, "the largest, over the worlds, of the cost of the cheapest schedule"]
    bound: Annotated[int | None, "the largest of these worlds; null without a bound"]
    tests: Annotated[
        Natural | None, "different tests of false hypotheses; null: not of Algorithm 1"
    ]
    wrong_tests: Annotated[Natural | None, "those that confirmed one; null: not of Algorithm 1"]
    world: Annotated[WorldDocument, "the least one that attains `worst`"]
    choices: Annotated[list[Natural], "that attain it there"]
    replayed: Annotated[
        Natural | None,
        "what they cost in the Python engine; null: it did not keep every law",
    ]


class WorstDocument(InRows, OfClass):
    """Report of 'worst'."""

    exit_code: Annotated[
        int, code(Exit.ANSWERED, Exit.REFUTED, Exit.VACUOUS, Exit.DISAGREES, Exit.INTERRUPTED)
    ]
    explorer: Annotated[Text, "its name"]
    lighthouse: Annotated[Text, "`KIND[:key=value,...]`"]
    edges: Annotated[Positive, "at most so many"]
    transit: Annotated[
        Literal["shortest", "simple"] | None,
        "the paths by which Algorithm 1 goes to the next edge; null: another explorer",
    ]
    schedules: Annotated[Literal["all", "one"], "one: the explorer takes no choices"]
    symmetry: Annotated[
        Text | None, "why one world stands for every direction; null: each was tried"
    ]
    shard: Annotated[str, OfShard, "`K/N`; `0/1` is the whole"]
    gate: Annotated[Gate, "counts, of a shard left to the merge, and replays in the Python engine"]
    rows: Annotated[list[WorstRowDocument], "one for each (edges, vertices), ascending"]
    findings: Annotated[
        list[FindingDocument], "the smallest, if a run of another explorer broke a law"
    ]


class SpreadDocument(TypedDict):
    """A figure over the rounds."""

    median: Figure
    lowest: Figure
    highest: Figure


class ContenderDocument(TypedDict):
    """A contender and what was measured of it."""

    name: Annotated[Text, "what it is called"]
    does: Annotated[Text, "what it does, in words, or its command"]
    edges: Annotated[Positive, "the level that it walks"]
    worlds: Annotated[Positive, "the rooted maps of that level"]
    seconds: Annotated[list[Seconds], Some, "of each round"]
    worlds_per_second: Annotated[SpreadDocument, "over the rounds"]


class Ratio(TypedDict):
    """Two rates side by side."""

    of: Annotated[Text, "the kernel on one thread"]
    to: Annotated[Text, "another contender"]
    ratio: Annotated[SpreadDocument, "the rate of the one divided by that of the other"]


class BenchDocument(InRows):
    """Report of 'bench'."""

    commit: Annotated[Text | None, "of the sources; null outside a checkout"]
    edges: Annotated[int, Keywords(minimum=4, maximum=10), "the level of the compiled engines"]
    rounds: Positive
    peak_mb: Annotated[Natural, "the largest memory that the process has had"]
    contenders: Annotated[list[ContenderDocument], Some, "the reference first"]
    ratios: Annotated[list[Ratio], "the reference to each other one"]


class EntryDocument(TypedDict):
    """One thing that a corpus keeps."""

    name: Annotated[Text, "unique in the corpus"]
    kind: Annotated[Literal["world", "finding", "pair", "counts", "check"], "what the file holds"]
    file: Annotated[Text, "where it stands, below the corpus"]
    sha256: Annotated[str, Keywords(pattern="^[0-9a-f]{64}$"), "of the file"]
    provenance: Annotated[Text, "where it comes from"]
    expected: Annotated[dict[str, object], "what must come out when it is tried"]


class Manifest(TypedDict):
    """Manifest of a corpus."""

    schema: Version
    entries: Annotated[list[EntryDocument], "what is kept, in the order in which it is told"]


class Branch(TypedDict):
    """What to do after a percept."""

    percept: Annotated[PerceptDocument, "what is sensed"]
    node: Annotated[Natural, "the node to go on with, by its place in `nodes`"]


class StrategyStep(TypedDict):
    """A node of a strategy: a motion."""

    move: Annotated[Natural, "by how many darts clockwise the robot turns before it leaves"]
    then: Annotated[list[Branch], Some, "where to go on"]


class StrategyLeaf(TypedDict):
    """A node of a strategy: the end."""

    answer: Annotated[Rooted, "the map, and the robot's dart in it"]


class StrategyDocument(TypedDict):
    """A strategy."""

    start: Annotated[list[Branch], Some, "where to begin after the first percept"]
    nodes: Annotated[list[StrategyStep | StrategyLeaf], Some, "what to do"]


class OptimumRowDocument(TypedDict):
    """The worlds with one number of edges, which the explorer knows."""

    edges: Positive
    runs: Annotated[Positive, "worlds with every bearing"]
    optimum: Annotated[
        Natural | None,
        "the fewest traversals that are enough in every world; null: the time was up",
    ]
    at_least: Annotated[Natural, "no explorer needs less in its worst world"]
    replayed: Annotated[
        Natural | None,
        "what the strategy costs at its worst, followed in every world; null: there is none, or "
        "it is wrong",
    ]
    states: Annotated[Natural, "how many states of knowledge were looked into"]
    explorers: Annotated[dict[str, Natural], "the worst cost of each built-in explorer"]
    strategy: Annotated[StrategyDocument | None, "one that attains the optimum"]


class OptimumDocument(InRows):
    """Report of 'optimum'."""

    rows: Annotated[list[OptimumRowDocument], "by the number of edges"]
