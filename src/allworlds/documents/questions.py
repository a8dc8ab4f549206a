"""What is written about maps, worlds and engines; and the manifest of a corpus."""

from typing import Annotated, Literal, NotRequired, TypedDict

from allworlds.documents.common import ExtentDocument, Gate, InRows, OfClass, ReportDocument
from allworlds.documents.findings import FindingDocument
from allworlds.documents.vocabulary import (
    Dart,
    Keywords,
    Named,
    Natural,
    OfShard,
    Positive,
    Some,
    Text,
    Two,
    code,
)
from allworlds.documents.worlds import PerceptDocument, Rooted, Transcript, WorldDocument
from allworlds.outcome import Exit


class InitDocument(ReportDocument):
    """Report of 'init'."""

    directory: Annotated[Text, "as it was named"]
    lang: Annotated[str, Named("explorers:LANGUAGES"), "of the explorer"]
    files: Annotated[list[Text], "that were written, relative to the directory, sorted"]
    explorer: Annotated[Text, "the file to be filled in"]
    check: Annotated[Text, "a shell command that checks it"]
    test: Annotated[Text, "a shell command that runs its test, in the directory"]


class PlayDocument(ReportDocument):
    """Report of 'play'."""

    path: Annotated[str | None, "the page in which it is played; null where it was played here"]
    world: WorldDocument
    transcript: Annotated[Transcript, "what was done and sensed; of a page the start alone"]


class HeaderDocument(ReportDocument):
    """Report of 'native'."""

    version: Annotated[Positive, "of the interface: `ALLWORLDS_VERSION`"]
    header: Annotated[Text, "`allworlds.h`"]


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


class QuotientDocument(TypedDict):
    """A rooted quotient: its dart 0 is that of the start."""

    sigma: Annotated[list[Dart], Some, "for each class of darts the next one clockwise"]
    alpha: Annotated[
        list[Dart], Some, "for each class the one at the other end; itself for a semi-edge"
    ]
    degree: Annotated[list[Positive], Some, "what is sensed at each class"]
    marks: Annotated[list[Natural], Some, "what is sensed at each class"]


class CensusRowDocument(TypedDict):
    """The marked maps with one number of edges."""

    edges: Positive
    marked_worlds: Annotated[Natural, "maps with one marked vertex, up to isomorphism"]
    ambiguous_worlds: Annotated[
        Natural | None, "those with a twin inside the class of maps; null: of a shard"
    ]
    classes: Annotated[
        Natural | None, "ambiguity classes with two members there, or more; null: of a shard"
    ]
    largest_class: Annotated[
        Natural | None, "the members of the largest; 0: there is none, null: of a shard"
    ]


class AmbiguityCensusDocument(InRows, ExtentDocument):
    """Report of 'ambiguity census'."""

    lighthouse: Annotated[str, Keywords(const="position")]
    shard: Annotated[str, OfShard, "`K/N`; `0/1` is the whole"]
    gate: Annotated[Gate, "the comparison of the rooted maps with an independent source"]
    rows: Annotated[list[CensusRowDocument], "one a number of edges, ascending"]


class AmbiguityClassDocument(ReportDocument, OfClass):
    """Report of 'ambiguity class'."""

    world: Annotated[WorldDocument, "as it was understood"]
    ambiguous: Annotated[bool, "whether there is another one that looks alike"]
    size: Annotated[Positive, "how many worlds there are in the ambiguity class"]
    poses: Annotated[Positive, "how many pairs of a world and a dart where the robot can be"]
    sheets: Annotated[Positive, "of the world as a cover of its quotient"]
    listed: Annotated[Positive, "how many worlds are listed"]
    notice: Annotated[Text | None, "what is left out, where anything is"]
    worlds: Annotated[
        list[WorldDocument],
        Some,
        "the given one first; each with start 0, where the robot could be",
    ]
    quotient: Annotated[QuotientDocument, "what a robot can know"]


class TwinsDocument(ReportDocument):
    """Report of 'twins'."""

    worlds: Annotated[list[WorldDocument], Two, "the two, as they were understood"]
    relation: Annotated[
        Literal["same", "same-map", "different"],
        "`same`: one world; `same-map`: one world entered at two darts; `different`",
    ]
    distinguishable: Annotated[bool, "whether any motion tells them apart"]
    twins: Annotated[bool, "different, and not distinguishable"]
    motions: NotRequired[
        Annotated[list[Natural], "if distinguishable: the shortest motions that tell them apart"]
    ]
    percepts: NotRequired[
        Annotated[
            list[Annotated[list[PerceptDocument], Some]],
            Two,
            "with them: for each world what is sensed at the start and after each motion",
        ]
    ]
    bisimulation: NotRequired[
        Annotated[
            list[Annotated[list[Natural], Keywords(minItems=2)]],
            Two,
            "if not: for each world the class of each dart",
        ]
    ]


class SearchLevel(TypedDict):
    """One level of a search."""

    edges: Annotated[list[Positive], Two, "of each world"]
    vertices: Annotated[
        list[Annotated[list[Positive], Two]], Two, "for each world the fewest and the most"
    ]
    status: Literal["sat", "unsat", "unknown"]
    formula: Annotated[Text, "the path of the DIMACS file"]
    proof: Annotated[Text | None, "the path of the LRAT proof; null: there is none"]


class SearchDocument(ReportDocument, OfClass):
    """Report of 'search'."""

    status: Annotated[
        Literal["sat", "unsat", "unknown"], "`sat`: a pair; `unsat`: there is none in the bounds"
    ]
    exit_code: Annotated[
        int, code(Exit.ANSWERED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERRUPTED)
    ]
    pair: Annotated[
        Annotated[list[WorldDocument], Two] | None, "two worlds that look alike; null unless `sat`"
    ]
    bisimulation: Annotated[
        Annotated[list[Annotated[list[Natural], Keywords(minItems=2)]], Two] | None,
        "for each of them the class of each dart; null unless `sat`",
    ]
    certificate: Annotated[
        Text | None, "the path of what proves the answer; null: see [answers](search.md#answers)"
    ]
    vacuous: Annotated[bool, "not even one world exists within the bounds"]
    lighthouse: Annotated[str, Named("studies.ambiguity.smt.question:SEARCHED")]
    vertices: Annotated[Positive, "at most so many"]
    edges: Annotated[Positive, "at most so many"]
    directory: Annotated[Text, "where the formulas are"]
    levels: Annotated[list[SearchLevel], "in the order of the search"]
    same_map: Annotated[
        list[Annotated[list[WorldDocument], Two]],
        "pairs that look alike but are one map with two starts",
    ]
    notices: Annotated[list[Text], "sentences for the reader"]


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
