"""Independent sources of the counts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product
from math import comb, factorial, prod

from allworlds.maps.counting.any_genus import (
    Degrees,
    carrell_chapuy,
    rooted_maps,
    rooted_of_genus,
    rooted_of_genus_by_contraction,
    rooted_planar,
)
from allworlds.maps.counting.arithmetic import (
    Series,
    coefficient,
    exactly,
    geometric,
    partitions,
    plus,
    scaled,
    series_product,
    times,
    vertex_counts,
)
from allworlds.maps.counting.atlas import (
    rooted_planar_simple,
    rooted_simple,
)


def rooted_planar_simple_by_substitution(edges: int) -> dict[int, int]:
    """``{vertices: rooted simple planar maps}`` with that many edges.

    Two substitutions lead from simple to all planar maps.  A planar map is one without loops
    with a sequence of loops, each with a map inside, in each of its 2k corners, the root's
    corner having two sides.  A map without loops is a simple one with each edge kept or
    opened to a 2-gon, and in it a map without loops whose root edge has been opened.  Both
    are solved for the inner series.
    Raises: ValueError for edges < 1.
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
    Raises: ValueError for edges < 1.  Cost: the partitions of 2m.
    """
    degrees = frozenset(range(1, 2 * edges + 1)) if legal is None else legal
    return {
        n: exactly(2 * edges * _connected_rotations(n, edges, degrees), factorial(n))
        for n in vertex_counts(edges)
    }


@cache
def _connected_rotations(vertices: int, edges: int, legal: Degrees) -> int:
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
def _rotations(vertices: int, edges: int, legal: Degrees) -> int:
    """As :func:`_connected_rotations`, of all graphs without isolated vertices."""
    if edges > comb(vertices, 2):
        return 0
    total = 0
    for degrees in partitions(2 * edges, vertices, vertices - 1):
        if not legal.issuperset(degrees):
            continue
        orders = factorial(vertices) // prod(map(factorial, Counter(degrees).values()))
        total += orders * _graphs(degrees) * prod(factorial(d - 1) for d in degrees)
    return total


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
