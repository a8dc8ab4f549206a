"""Maps under a condition: **the** table of their sources, by the condition and the class of maps.

The degrees of a map's vertices decide whether it is cubic, regular or eulerian, and the sums over
degrees are restricted to these.  By duality there are as many triangulations or quadrangulations
with f faces as regular maps with f vertices, of each genus.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import factorial
from typing import TypeAlias

from allworlds.maps.counting.any_genus import (
    Degrees,
    catalan,
    rooted_of_degrees,
    rooted_of_degrees_by_contraction,
    rooted_of_genus,
)
from allworlds.maps.counting.arithmetic import exactly, vertex_counts
from allworlds.maps.counting.sources import CountSource, rooted_simple_by_degrees, sources

Cells: TypeAlias = dict[int, int]


def rooted_trees(edges: int) -> Cells:
    """``{vertices: rooted plane trees}``: Catalan numbers."""
    return {n: catalan(edges) if n == edges + 1 else 0 for n in vertex_counts(edges)}


def rooted_with_degrees(edges: int, degrees: Degrees, genera: Iterable[int]) -> Cells:
    """``{vertices: rooted maps}`` of these genera with legal degrees alone, by contraction."""
    each = [rooted_of_degrees_by_contraction(edges, genus, degrees) for genus in genera]
    return {n: sum(cells[n] for cells in each) for n in vertex_counts(edges)}


def rooted_with_faces(edges: int, length: int, genera: Iterable[int]) -> Cells:
    """``{vertices: rooted maps}`` of these genera, all of whose faces have that many darts."""
    cells = dict.fromkeys(vertex_counts(edges), 0)
    faces, rest = divmod(2 * edges, length)
    for genus in genera if rest == 0 else ():
        vertices = edges - faces + 2 - 2 * genus
        if vertices > 0:
            duals = rooted_of_degrees_by_contraction(edges, genus, frozenset({length}))
            cells[vertices] = duals[faces]
    return cells


def rooted_simple_triangulations(edges: int) -> Cells:
    """``{vertices: rooted simple planar triangulations}``, with k + 2 vertices and 3k edges.

    Source: W. T. Tutte, A census of planar triangulations, Canad. J. Math. 14 (1962):
    ``2 (4k-3)! / (k! (3k-1)!)``.
    """
    cells = dict.fromkeys(vertex_counts(edges), 0)
    k, rest = divmod(edges, 3)
    if not rest:
        cells[k + 2] = exactly(2 * factorial(4 * k - 3), factorial(k) * factorial(3 * k - 1))
    return cells


def _genera(map_class: str, edges: int) -> range:
    return range(1) if map_class == "planar" else range(edges // 2 + 1)


def _of_degrees(map_class: str, legal: Callable[[int], bool]) -> tuple[CountSource, ...]:
    """Sources for the maps whose degrees are all legal."""

    def degrees(edges: int) -> Degrees:
        return frozenset(filter(legal, range(1, 2 * edges + 1)))

    by_cycles = CountSource(
        "log-series of permutations with these cycles", lambda m: rooted_of_degrees(m, degrees(m))
    )
    by_contraction = CountSource(
        "Walsh-Lehman recurrence at these degrees",
        lambda m: rooted_with_degrees(m, degrees(m), _genera(map_class, m)),
    )
    by_graphs = CountSource(
        "these degree sequences of labelled graphs",
        lambda m: rooted_simple_by_degrees(m, degrees(m)),
    )
    known = {
        "maps": (by_cycles, by_contraction),
        "planar": (by_contraction,),
        "simple": (by_graphs,),
    }
    return known.get(map_class, ())


def _of_faces(map_class: str, length: int) -> tuple[CountSource, ...]:
    if map_class in ("maps", "planar"):
        dual = CountSource(
            "Walsh-Lehman recurrence of the dual maps",
            lambda m: rooted_with_faces(m, length, _genera(map_class, m)),
        )
        return (dual,)
    if (map_class, length) == ("planar-simple", 3):
        return (CountSource("Tutte's census of triangulations", rooted_simple_triangulations),)
    return ()


def _of_genus(map_class: str, genus: int) -> tuple[CountSource, ...]:
    if map_class == "maps":
        recurrence = CountSource("Carrell-Chapuy recurrence", lambda m: rooted_of_genus(m, genus))
        return (recurrence,)
    if genus == 0:
        return sources({"simple": "planar-simple"}.get(map_class, map_class))
    return ()


def _of_girth(map_class: str, least: int) -> tuple[CountSource, ...]:
    if least == 1:
        return sources(map_class)
    if "simple" in map_class:
        return sources(map_class) if least <= 3 else ()
    return sources({"maps": "simple", "planar": "planar-simple"}[map_class]) if least == 3 else ()


_NARROWED: dict[str, Callable[[str, int], tuple[CountSource, ...]]] = {
    "cubic": lambda map_class, _: _of_degrees(map_class, lambda d: d == 3),
    "regular": lambda map_class, degree: _of_degrees(map_class, lambda d: d == degree),
    "eulerian": lambda map_class, _: _of_degrees(map_class, lambda d: d % 2 == 0),
    "trees": lambda _class, _: (CountSource("Catalan numbers", rooted_trees),),
    "girth": _of_girth,
    "genus": _of_genus,
    "triangulation": lambda map_class, _: _of_faces(map_class, 3),
    "quadrangulation": lambda map_class, _: _of_faces(map_class, 4),
}


def sources_under(map_class: str, kind: str, number: int) -> tuple[CountSource, ...]:
    """The independent sources for a class under a condition with a name; there may be none."""
    return _NARROWED[kind](map_class, number)


def source_under(map_class: str, kind: str, number: int) -> CountSource | None:
    """The first of them, which is fast; None if there is none."""
    return next(iter(sources_under(map_class, kind, number)), None)
