"""**The** table of the sources of counts, by the class of maps."""

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
    "CountSource",
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
class CountSource:
    """A source of counts: ``cells(m)`` is ``{vertices: rooted maps}`` with m edges."""

    name: str
    cells: Callable[[int], dict[int, int]]


def sources(map_class: str) -> tuple[CountSource, ...]:
    """The independent sources for a class of maps; they agree wherever two know a cell.

    The first knows every cell and is fast.  Raises: ValueError for an unknown class.
    """
    known = {
        "maps": (
            CountSource("log-series of permutations", rooted_maps),
            CountSource("Carrell-Chapuy recurrence", _over_all_genera(rooted_of_genus)),
            CountSource(
                "Walsh-Lehman recurrence", _over_all_genera(rooted_of_genus_by_contraction)
            ),
        ),
        "planar": (
            CountSource("Carrell-Chapuy recurrence", rooted_planar),
            CountSource("Walsh-Lehman recurrence", lambda m: rooted_of_genus_by_contraction(m, 0)),
        ),
        "simple": (
            CountSource("degree sequences of labelled graphs", rooted_simple_by_degrees),
            CountSource("graph atlas and Catalan numbers", rooted_simple),
        ),
        "planar-simple": (
            CountSource("substitution into planar maps", rooted_planar_simple_by_substitution),
            CountSource(
                "graph atlas with genus-0 rotations and Catalan numbers", rooted_planar_simple
            ),
        ),
    }
    if map_class not in known:
        raise ValueError(f"unknown class of maps {map_class!r}; the classes are {', '.join(known)}")
    return known[map_class]


def source_for(map_class: str) -> CountSource:
    """The source that knows every cell of a class.  Raises: ValueError for an unknown class."""
    return sources(map_class)[0]


def _over_all_genera(
    cells: Callable[[int, int], dict[int, int]],
) -> Callable[[int], dict[int, int]]:
    def summed(edges: int) -> dict[int, int]:
        by_genus = [cells(edges, genus) for genus in range(edges // 2 + 1)]
        return {n: sum(cell[n] for cell in by_genus) for n in vertex_counts(edges)}

    return summed
