"""**The** tables of the sources: by the class of maps, and by a condition besides."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from itertools import product
from math import comb, factorial, prod
from typing import NamedTuple, TypeAlias

from allworlds.maps.counting.any_genus import (
    Degrees,
    Series,
    carrell_chapuy,
    catalan,
    coefficient,
    exactly,
    geometric,
    plus,
    rooted_maps,
    rooted_of_genus,
    rooted_of_genus_by_contraction,
    scaled,
    sequences,
    series_product,
    times,
    vertex_counts,
)

Cells: TypeAlias = dict[int, int]


def rooted_planar_simple_by_substitution(edges: int) -> dict[int, int]:
    """``{vertices: rooted simple planar maps}`` with that many edges.

    Two substitutions lead from simple to all planar maps.  A planar map is one without loops
    with a sequence of loops, each with a map inside, in each of its 2k corners, the root's
    corner having two sides.  A map without loops is a simple one with each edge kept or
    opened to a 2-gon, and in it a map without loops whose root edge has been opened.  Both
    are solved for the inner series.
    Source: the compositions of W. T. Tutte, A census of planar maps, Canad. J. Math. 15 (1963).
    """
    vertices = vertex_counts(edges)
    # Series M / x: the vertex at the root, which each part has in common, is not counted.
    planar = [carrell_chapuy(m, 0)[1:] for m in range(edges + 1)]
    sequence = geometric([(), *planar[:-1]])
    square = series_product(sequence, sequence)
    loops = [sequence]
    for _ in range(edges):
        loops.append([(), *series_product(loops[-1], square)[:-1]])
    loopless = _coefficients(planar, loops)
    # One edge has two vertices, and the second is not counted inside a 2-gon either.
    bundle: Series = [(), (1,), *(p[1:] for p in loopless[1:-1])]
    unit: Series = [(1,), *[()] * edges]
    bundles = [unit]
    for _ in range(edges):
        bundles.append(series_product(bundles[-1], bundle))
    simple = _coefficients(loopless, bundles)[edges]
    return {n: coefficient(simple, n - 1) for n in vertices}


def _coefficients(outer: Series, parts: Sequence[Series]) -> Series:
    """The polynomials c with ``outer = sum_k c_k parts[k]``, where ``parts[k] = z^k + ...``."""
    found: Series = []
    for m, polynomial in enumerate(outer):
        known = [times(c, part[m]) for c, part in zip(found, parts, strict=False)]
        found.append(plus(polynomial, *(scaled(-1, p) for p in known)))
    return found


def rooted_simple_by_degrees(edges: int, legal: Degrees | None = None) -> dict[int, int]:
    """``{vertices: rooted simple maps}`` with that many edges, of any orientable genus.

    With ``legal`` those alone whose degrees are all among these.

    A graph has ``prod (deg-1)!`` rotation systems; labelled graphs are counted by degree
    sequence, and a rooted map has ``n!`` labellings of its vertices.
    Cost: the partitions of 2m.
    """
    return {
        n: exactly(2 * edges * _connected_rotations(n, edges, legal), factorial(n))
        for n in vertex_counts(edges)
    }


@cache
def _connected_rotations(vertices: int, edges: int, legal: Degrees | None) -> int:
    """Rotation systems of connected simple graphs on labelled vertices, with m >= 1 edges."""
    if not vertices - 1 <= edges <= comb(vertices, 2):
        return 0
    split = sum(
        comb(vertices - 1, k - 1)
        * _connected_rotations(k, j, legal)
        * _rotations(vertices - k, edges - j, legal)
        for k in range(2, vertices)
        for j in range(k - 1, edges)
    )
    return _rotations(vertices, edges, legal) - split


@cache
def _rotations(vertices: int, edges: int, legal: Degrees | None) -> int:
    """As :func:`_connected_rotations`, of all graphs without isolated vertices."""
    if edges > comb(vertices, 2):
        return 0
    return sum(
        orders * _graphs(degrees) * prod(factorial(d - 1) for d in degrees)
        for degrees, orders in sequences(2 * edges, vertices, vertices - 1, legal)
    )


@cache
def _graphs(degrees: tuple[int, ...]) -> int:
    """Labelled simple graphs with these degrees (falling, all positive)."""
    if not degrees:
        return 1
    first, rest = degrees[0], Counter(degrees[1:])
    if first > rest.total():
        return 0
    total = 0
    for taken in product(*(range(count + 1) for count in rest.values())):
        if sum(taken) != first:
            continue
        left: Counter[int] = Counter()
        for (d, count), t in zip(rest.items(), taken, strict=True):
            left[d] += count - t
            left[d - 1] += t
        left[0] = 0
        ways = prod(comb(count, t) for count, t in zip(rest.values(), taken, strict=True))
        total += ways * _graphs(tuple(sorted(left.elements(), reverse=True)))
    return total


class CountSource(NamedTuple):
    """A source of counts: ``cells(m)`` is ``{vertices: rooted maps}`` with m edges."""

    name: str
    cells: Callable[[int], Cells]


def rooted_trees(edges: int) -> Cells:
    """``{vertices: rooted plane trees}``: Catalan numbers."""
    return {n: catalan(edges) if n == edges + 1 else 0 for n in vertex_counts(edges)}


def rooted_with_faces(edges: int, length: int, genera: Iterable[int]) -> Cells:
    """``{vertices: rooted maps}`` of these genera, all of whose faces have that many darts."""
    cells = dict.fromkeys(vertex_counts(edges), 0)
    faces, rest = divmod(2 * edges, length)
    for genus in genera if rest == 0 else ():
        vertices = edges - faces + 2 - 2 * genus
        if vertices > 0:
            duals = rooted_of_genus_by_contraction(edges, genus, frozenset({length}))
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


def _of_degrees(map_class: str, legal: Callable[[int], bool]) -> CountSource | None:
    """The source for the maps whose degrees are all legal."""

    def degrees(edges: int) -> Degrees:
        return frozenset(filter(legal, range(1, 2 * edges + 1)))

    known = {
        "maps": CountSource(
            "log-series of permutations with these cycles", lambda m: rooted_maps(m, degrees(m))
        ),
        "planar": CountSource(
            "Walsh-Lehman recurrence at these degrees",
            lambda m: rooted_of_genus_by_contraction(m, 0, degrees(m)),
        ),
        "simple": CountSource(
            "these degree sequences of labelled graphs",
            lambda m: rooted_simple_by_degrees(m, degrees(m)),
        ),
    }
    return known.get(map_class)


def _of_faces(map_class: str, length: int) -> CountSource | None:
    if map_class in ("maps", "planar"):
        return CountSource(
            "Walsh-Lehman recurrence of the dual maps",
            lambda m: rooted_with_faces(
                m, length, range(1 if map_class == "planar" else m // 2 + 1)
            ),
        )
    if (map_class, length) == ("planar-simple", 3):
        return CountSource("Tutte's census of triangulations", rooted_simple_triangulations)
    return None


def _of_genus(map_class: str, genus: int) -> CountSource | None:
    if map_class == "maps":
        return CountSource("Carrell-Chapuy recurrence", lambda m: rooted_of_genus(m, genus))
    if genus == 0:
        return SOURCES[{"simple": "planar-simple"}.get(map_class, map_class)]
    return None


def _of_girth(map_class: str, least: int) -> CountSource | None:
    if least == 1:
        return SOURCES[map_class]
    if least > 3 or (least == 2 and "simple" not in map_class):
        return None
    return SOURCES[{"maps": "simple", "planar": "planar-simple"}.get(map_class, map_class)]


SOURCES: dict[str, CountSource] = {
    "maps": CountSource("log-series of permutations", rooted_maps),
    "planar": CountSource("Carrell-Chapuy recurrence", lambda m: rooted_of_genus(m, 0)),
    "simple": CountSource("degree sequences of labelled graphs", rooted_simple_by_degrees),
    "planar-simple": CountSource(
        "substitution into planar maps", rooted_planar_simple_by_substitution
    ),
}
"""By a class of maps: it knows every cell."""

NARROWED: dict[str, Callable[[str, int], CountSource | None]] = {
    "cubic": lambda map_class, _: _of_degrees(map_class, lambda d: d == 3),
    "regular": lambda map_class, degree: _of_degrees(map_class, lambda d: d == degree),
    "eulerian": lambda map_class, _: _of_degrees(map_class, lambda d: d % 2 == 0),
    "trees": lambda _class, _: CountSource("Catalan numbers", rooted_trees),
    "girth": _of_girth,
    "genus": _of_genus,
    "triangulation": lambda map_class, _: _of_faces(map_class, 3),
    "quadrangulation": lambda map_class, _: _of_faces(map_class, 4),
}
"""By a condition: of the class of maps and the number in its name; None: there is no source."""
