"""The values with which an enumeration is compared, and the number of completions of a gluing.

The count gate compares the numbers of the enumerated maps with numbers from a *source*: a formula
or recurrence of the module ``counting`` that makes no map (:func:`source_of`).  The gate also
compares the fingerprints of the maps with those of a plainer enumeration (:func:`listed`).

A *gluing* is an unfinished map; the module ``enumeration`` explains how maps are glued together.  A
*completion* is a rooted map that a gluing can become.
"""

from collections import Counter
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType
from typing import TypeAlias

from allworlds.maps.classes import Extent, MapClass, NamedCondition
from allworlds.maps.counting import NARROWED, SOURCES, CountSource
from allworlds.maps.enumeration import FINGERPRINTS, Gluing, fingerprint, rooted_maps

NewParts: TypeAlias = tuple[int, int]
"""The numbers of new darts and of new vertices."""

NOTHING: Mapping[NewParts, int] = MappingProxyType({(0, 0): 1})


def completions(gluing: Gluing) -> int:
    """The number of rooted maps that this gluing can become; in simple classes an upper bound.

    The gluing must have at least one vertex.  Cost: microseconds; polynomial in the edges.
    """
    left = gluing.limit - len(gluing.degrees)
    if not gluing.planar:
        return _anywhere(sum(map(len, gluing.faces)), gluing.owed, left)
    whole = NOTHING
    for face in gluing.faces:
        whole = _product(whole, _fillings(len(face), gluing.owed))
    return sum(ways for (darts, new), ways in whole.items() if darts == gluing.owed and new <= left)


@cache
def _anywhere(open_: int, owed: int, vertices: int) -> int:
    """The number of ways to finish a gluing of any genus, in which any two open darts may be glued.

    Args:
        open_: the number of open darts.
        owed: the number of darts that must still be made.
        vertices: the largest number of vertices that may still be made.
    """
    if open_ == 0:
        return int(owed == 0)
    ways = (open_ - 1) * _anywhere(open_ - 2, owed, vertices) if open_ > 1 else 0
    if vertices:
        for degree in range(1, owed + 1):
            ways += _anywhere(open_ + degree - 2, owed - degree, vertices - 1)
    return ways


@cache
def _fillings(open_: int, most: int) -> Mapping[NewParts, int]:
    """The numbers of ways to finish a face of a planar gluing, by the new parts that they make.

    The face has ``open_`` open darts, and is finished when it has no open dart.  Only ways that
    make at most ``most`` new darts are counted.  A key of the result is a pair: a number of new
    darts, and a number of new vertices.  The value is the number of the ways that make these
    numbers.  The oldest open dart is glued either to another open dart of the face, which divides
    the face into two faces, or to a new vertex, whose other darts become open darts of the same
    face.
    """
    if open_ == 0:
        return NOTHING
    ways: Counter[NewParts] = Counter()
    for between in range(open_ - 1):
        pair = _product(_fillings(between, most), _fillings(open_ - 2 - between, most))
        ways.update({size: count for size, count in pair.items() if size[0] <= most})
    for degree in range(1, most + 1):
        for (darts, new), count in _fillings(open_ + degree - 2, most - degree).items():
            ways[darts + degree, new + 1] += count
    return ways


def _product(a: Mapping[NewParts, int], b: Mapping[NewParts, int]) -> Mapping[NewParts, int]:
    ways: Counter[NewParts] = Counter()
    for (darts, new), count in a.items():
        for (more, others), times in b.items():
            ways[darts + more, new + others] += count * times
    return ways


def source_of(extent: Extent) -> CountSource | None:
    """The formula or recurrence that counts the maps of ``extent``; None if there is none.

    There is none in three cases.  First: the extent has given maps.  Second: its condition is a
    user's own one, or consists of several conditions.  Third: the module ``counting`` has no source
    for this built-in condition in this class of maps.
    """
    where = extent.where
    if extent.given is not None:
        return None
    if where is None:
        return SOURCES[extent.map_class]
    if isinstance(where, NamedCondition):
        return NARROWED[where.kind](extent.map_class, where.number)
    return None


@cache
def listed(extent: Extent, edges: int) -> Mapping[int, int]:
    """The sums of the fingerprints of the extent's maps with ``edges`` edges.

    The key is a number of vertices; the value is the sum for the maps with so many vertices, modulo
    :data:`FINGERPRINTS`.  The maps are enumerated in the plainest way: all rooted maps with
    ``edges`` edges are made, and then those of the extent are selected.  The work is not divided,
    and no unfinished map is given up early.
    Cost: up to 5 edges 0.3 s; 0.03 ms for each map of any class.
    """
    sums: Counter[int] = Counter()
    for map_ in rooted_maps(edges, MapClass.MAPS):
        if extent.include(map_):
            sums[map_.vertex_count] += fingerprint(map_)
    return {vertices: each % FINGERPRINTS for vertices, each in sums.items()}
