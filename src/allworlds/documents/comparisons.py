"""What is written about explorers side by side: in a class of worlds, and as worlds grow."""

from typing import Annotated, TypedDict

from allworlds.documents.common import InRows, OfClass
from allworlds.documents.findings import FindingDocument
from allworlds.documents.vocabulary import Figure, Natural, Positive, Some, Text, VerdictName, code
from allworlds.documents.worlds import WorldDocument
from allworlds.outcome import Exit


class Compared(TypedDict):
    """An explorer of a comparison, and how it was run."""

    name: Annotated[Text, "the explorer's"]
    lighthouse: Annotated[Text, "`KIND[:key=value,...]`"]
    policy: Annotated[Text, "who answered its choices"]
    bound: Annotated[Text, "the bound on its traversals; `none` where the law was not checked"]


class CompareRow(TypedDict):
    """What explorers walk in the worlds of one size; the first is compared with each other one."""

    edges: Positive
    vertices: Positive
    worlds: Annotated[Positive, "rooted maps in which every explorer's lighthouse has a place"]
    runs: Annotated[Positive, "judged in them, of all explorers together"]
    mean: Annotated[
        dict[str, Figure], "for each explorer the mean over these maps of its mean over the places"
    ]
    worst: Annotated[dict[str, Natural], "for each explorer the largest cost of a run"]
    ratio: Annotated[
        dict[str, Figure | None], "the mean divided by that of the first; null where that is 0"
    ]
    less: Annotated[
        dict[str, Natural], "in how many maps the first one's mean is less than this one's"
    ]
    equal: Annotated[dict[str, Natural], "in how many it is equal"]
    more: Annotated[dict[str, Natural], "in how many it is more"]


class DifferMostDocument(TypedDict):
    """The smallest of the worlds in which the first explorer differs most from another."""

    world: Annotated[WorldDocument, "the rooted map, with the first one's lighthouse"]
    costs: Annotated[dict[str, Figure], "for each explorer its mean over the places"]


class CompareDocument(InRows, OfClass):
    """Report of 'compare'."""

    verdict: Annotated[VerdictName, "whether a run of any explorer broke a law"]
    exit_code: Annotated[
        int,
        code(
            *(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERNAL),
            Exit.INTERRUPTED,
        ),
    ]
    explorers: Annotated[list[Compared], Some, "in the order in which they were named"]
    family: Annotated[Text | None, "the one world, with its seed; null: a class of worlds"]
    edges: Annotated[Positive | None, "at most so many; null: not bounded, or a family"]
    vertices: Annotated[Positive | None, "at most so many; null: not bounded, or a family"]
    rows: Annotated[list[CompareRow], "one for each (edges, vertices) of the finished levels"]
    differ_most: Annotated[
        DifferMostDocument | None, "null: nothing was compared, or nothing differs"
    ]
    stopped: Annotated[str | None, "why it is not complete; null: it is, or by the user"]
    findings: Annotated[list[FindingDocument], "the smallest of each explorer that broke a law"]


class GrowthRowDocument(TypedDict):
    """What an explorer walks in the members of a family of one size."""

    family: Annotated[Text, "as it was asked for"]
    edges: Annotated[Positive, "of each member"]
    vertices: Annotated[Positive, "of the first member"]
    explorer: Annotated[Text, "its name"]
    mean: Annotated[Figure, "traversals"]
    least: Annotated[Natural, "traversals"]
    worst: Annotated[Natural, "traversals"]
    bound: Annotated[int | None, "the largest bound of a run; null without a bound"]
    members: Annotated[list[Text], Some, "the worlds, as `run --family` takes them"]
    costs: Annotated[list[Natural], Some, "of the runs in them"]


class ExponentDocument(TypedDict):
    """How an explorer's cost grows in a family: like the edges to this power."""

    family: Annotated[Text, "as it was asked for"]
    explorer: Annotated[Text, "its name"]
    exponent: Annotated[float, "fitted to the means of all sizes, by least squares of logarithms"]
    last: Annotated[float, "the same of the last two sizes"]


class GrowthDocument(InRows):
    """Report of 'grow'."""

    verdict: Annotated[VerdictName, "whether a run broke a law"]
    exit_code: Annotated[
        int, code(*(Exit.HOLDS, Exit.REFUTED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERRUPTED))
    ]
    explorers: Annotated[list[Text], Some, "in the order in which they were named"]
    families: Annotated[list[Text], Some, "likewise"]
    rows: Annotated[list[GrowthRowDocument], "one for each family, size and explorer"]
    exponents: Annotated[
        list[ExponentDocument], "one for each family and explorer with two sizes or more"
    ]
    left_out: Annotated[Natural, "members in which a lighthouse had no place"]
    stopped: Annotated[str | None, "why it is not complete; null: it is, or by the user"]
    findings: Annotated[list[FindingDocument], "the smallest of each explorer in each family"]
