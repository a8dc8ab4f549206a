"""What is written about maps, worlds and engines; and the manifest of a corpus."""

from typing import Annotated, Literal, NotRequired, TypedDict

from allworlds.documents.common import ExtentDocument, Gate, InRows, OfClass, ReportDocument
from allworlds.documents.vocabulary import (
    Dart,
    Figure,
    Keywords,
    Named,
    Natural,
    OfShard,
    Positive,
    Seconds,
    Some,
    Text,
    Two,
    Version,
    code,
)
from allworlds.documents.worlds import PerceptDocument, Transcript, WorldDocument
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
