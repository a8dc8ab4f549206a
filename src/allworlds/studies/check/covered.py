"""A table of the features of a sample's worlds: the least, the median and the largest values."""

from collections import Counter
from collections.abc import Iterator
from typing import Annotated

from allworlds.documents.document import Document, Natural, Text, about
from allworlds.maps.combinatorial import CombinatorialMap


def telling_apart(map_: CombinatorialMap) -> tuple[int, int]:
    """The number of sheets of the map, and the number of traversals that tell darts apart.

    There is no lighthouse: a robot senses degrees alone.  Darts look alike if no walk tells them
    apart.  Classes of darts that look alike are equally large; their size is the number of sheets.
    Any two darts that do not look alike are told apart by a walk with at most as many traversals as
    the second number says.

    Cost: O(m log m) for each of these traversals.
    """
    seen, steps, count = map_.degree_at, 0, len(set(map_.degree_at))
    while True:
        names, jump = [seen[d] for d in map_.alpha], map_.sigma
        for _ in range(max(map_.degrees).bit_length()):  # round the vertex, in doubled paces
            pairs = dict[tuple[int, int], int]()
            names = [pairs.setdefault((names[d], names[jump[d]]), d) for d in map_.darts]
            jump = tuple(jump[d] for d in jump)
        both = dict[tuple[int, int], int]()
        pairs_of = zip(seen, names, strict=True)
        seen = tuple(both.setdefault(pair, d) for d, pair in enumerate(pairs_of))
        if len(both) == count:
            return len(seen) // count, steps
        steps, count = steps + 1, len(both)


FEATURES = (
    *("edges m", "vertices n", "largest degree", "diameter", "genus"),
    *("sheets", "longest test"),
)
"""The names of the features of a map, in the order of the rows of a report."""


def features(map_: CombinatorialMap) -> Iterator[tuple[str, int]]:
    """Yield the name and the value of each feature of a map, in the order of :data:`FEATURES`.

    :func:`telling_apart` makes the last two values.
    """
    sizes = map_.edge_count, map_.vertex_count, max(map_.degrees), map_.diameter, map_.genus
    return zip(FEATURES, (*sizes, *telling_apart(map_)), strict=True)


class CoveredRow(Document):
    """A feature, such as the genus, and its values in the drawn worlds."""

    feature: Annotated[Text, about("its name")]
    least: Annotated[Natural, about("the least value in a drawn world")]
    median: Annotated[Natural, about("the value of the middle one; of two, the less")]
    most: Annotated[Natural, about("the largest value")]


def covered_rows(counted: Counter[tuple[str, int]]) -> Iterator[CoveredRow]:
    """Yield a row for each feature; ``counted`` has the number of worlds by (feature, value)."""
    for name in FEATURES:
        values = sorted(Counter({v: n for (of, v), n in counted.items() if of == name}).elements())
        if values:
            yield CoveredRow(
                feature=name,
                least=values[0],
                median=values[(len(values) - 1) // 2],
                most=values[-1],
            )
