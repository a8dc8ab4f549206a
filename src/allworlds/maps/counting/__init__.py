"""How many rooted maps there are: the count gate, computed without making a single map.

An enumeration is exhaustive if its counts equal counts from somewhere else.  Here is the
somewhere else: generating functions, recurrences and sums over graphs from the literature.
Nothing is shared with the code that enumerates maps, nor with that of the maps themselves.

All functions return exact integers by number of vertices (or genus) for one number of edges
``m >= 1``.  A connected map with m edges has ``1..m+1`` vertices; a key in that range with
value 0 says that there is no such map, a missing key that the source does not know.

============================  ===========================================================
all maps                      pairs of permutations, the recurrences of Carrell and Chapuy
                              and of Walsh and Lehman
planar maps                   the same two recurrences at genus 0
simple maps                   degree sequences; for up to 7 vertices the graph atlas
simple planar maps            substitution into planar maps; for up to 7 vertices and few
                              rotations the graph atlas
trees (one class in all)      Catalan numbers
============================  ===========================================================

A polynomial is a tuple of integer coefficients, lowest power first.  In the comments z marks
edges and x vertices.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from allworlds.maps.counting.any_genus import (
    catalan,
    rooted_maps,
    rooted_of_genus,
    rooted_of_genus_by_contraction,
    rooted_planar,
)
from allworlds.maps.counting.arithmetic import vertex_counts
from allworlds.maps.counting.atlas import (
    ATLAS_VERTICES,
    ROTATIONS_LIMIT,
    rooted_planar_simple,
    rooted_simple,
)
from allworlds.maps.counting.degrees import rooted_simple_by_degrees
from allworlds.maps.counting.substitution import rooted_planar_simple_by_substitution

__all__ = [
    "ATLAS_VERTICES",
    "ROTATIONS_LIMIT",
    "Source",
    "catalan",
    "rooted_maps",
    "rooted_of_genus",
    "rooted_of_genus_by_contraction",
    "rooted_planar",
    "rooted_planar_simple",
    "rooted_planar_simple_by_substitution",
    "rooted_simple",
    "rooted_simple_by_degrees",
    "source_for",
    "sources",
]


@dataclass(frozen=True, slots=True)
class Source:
    """Where counts come from: ``cells(m)`` is ``{vertices: rooted maps}`` with m edges."""

    name: str
    cells: Callable[[int], dict[int, int]]


def sources(map_class: str) -> tuple[Source, ...]:
    """The independent sources for a class of maps; they agree wherever two know a cell.

    The first knows every cell and is fast.  Raises: ValueError for an unknown class.
    """
    known = {
        "maps": (
            Source("log-series of permutations", rooted_maps),
            Source("Carrell-Chapuy recurrence", _over_all_genera(rooted_of_genus)),
            Source("Walsh-Lehman recurrence", _over_all_genera(rooted_of_genus_by_contraction)),
        ),
        "planar": (
            Source("Carrell-Chapuy recurrence", rooted_planar),
            Source("Walsh-Lehman recurrence", lambda m: rooted_of_genus_by_contraction(m, 0)),
        ),
        "simple": (
            Source("degree sequences of labelled graphs", rooted_simple_by_degrees),
            Source("graph atlas and Catalan numbers", rooted_simple),
        ),
        "planar-simple": (
            Source("substitution into planar maps", rooted_planar_simple_by_substitution),
            Source("graph atlas with genus-0 rotations and Catalan numbers", rooted_planar_simple),
        ),
    }
    if map_class not in known:
        raise ValueError(f"unknown class of maps {map_class!r}; the classes are {', '.join(known)}")
    return known[map_class]


def source_for(map_class: str) -> Source:
    """The source that knows every cell of a class.  Raises: ValueError for an unknown class."""
    return sources(map_class)[0]


def _over_all_genera(
    cells: Callable[[int, int], dict[int, int]],
) -> Callable[[int], dict[int, int]]:
    def summed(edges: int) -> dict[int, int]:
        by_genus = [cells(edges, genus) for genus in range(edges // 2 + 1)]
        return {n: sum(cell[n] for cell in by_genus) for n in vertex_counts(edges)}

    return summed
