"""Simple planar maps, all of them: substitution into planar maps."""

from __future__ import annotations

from collections.abc import Sequence

from allworlds.maps.counting.any_genus import carrell_chapuy
from allworlds.maps.counting.arithmetic import (
    Series,
    coefficient,
    geometric,
    plus,
    scaled,
    series_product,
    times,
    vertex_counts,
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
