"""Maps of any genus: pairs of permutations, and the recurrences of the literature."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from functools import cache
from itertools import combinations
from math import comb, factorial, perm, prod
from typing import TypeAlias

from allworlds.maps.counting.arithmetic import (
    Polynomial,
    cells,
    check_edges,
    check_genus,
    divided,
    exactly,
    partitions,
    plus,
    scaled,
    times,
    vertex_counts,
)

Degrees: TypeAlias = frozenset[int]
"""The legal degrees of the vertices of a map."""


def catalan(n: int) -> int:
    """The Catalan number ``C(2n, n) / (n+1)``: rooted plane trees with n edges.

    Raises: ValueError for n < 0.
    """
    return comb(2 * n, n) // (n + 1)


def rooted_maps(edges: int) -> dict[int, int]:
    """``{vertices: rooted maps}`` with that many edges, of any orientable genus.

    The number is ``2m [z^m x^n] log sum_k (2k-1)!! x(x+1)...(x+2k-1) z^k / (2k)!``: all sigma by
    cycles, times all alpha, on labelled darts; log keeps the connected pairs, and a rooted
    map has ``(2m-1)!`` labellings.  Raises: ValueError for edges < 1.
    """
    return cells(edges, _rooted_by_permutations(edges))


def rooted_of_degrees(edges: int, degrees: Degrees) -> dict[int, int]:
    """``{vertices: rooted maps}`` with that many edges and legal degrees alone, of any genus.

    As :func:`rooted_maps`, but with those sigma alone whose cycles have legal lengths.
    Raises: ValueError for edges < 1.
    """
    return cells(edges, _rooted_of_degrees(edges, degrees))


@cache
def _rooted_by_permutations(edges: int) -> Polynomial:
    return _connected(edges, lambda k: _rising(2 * k), _rooted_by_permutations)


@cache
def _rooted_of_degrees(edges: int, degrees: Degrees) -> Polynomial:
    return _connected(
        edges,
        lambda k: _with_cycles(2 * k, degrees),
        lambda k: _rooted_of_degrees(k, degrees),
    )


def _connected(
    edges: int,
    permutations: Callable[[int], Polynomial],
    smaller: Callable[[int], Polynomial],
) -> Polynomial:
    # With b_k the permutations of 2k darts the sum is A = sum b_k z^k / (2^k k!), and R = 2 z A'/A.
    numerator = scaled(2 * edges, permutations(edges))
    for k in range(1, edges):
        weight = 2**k * perm(edges, k)
        term = times(smaller(k), permutations(edges - k))
        numerator = plus(numerator, scaled(-weight, term))
    return divided(numerator, 2**edges * factorial(edges))


@cache
def _with_cycles(length: int, degrees: Degrees) -> Polynomial:
    """Permutations of that many darts with cycles of legal lengths alone, by their cycles."""
    if length == 0:
        return (1,)
    result: Polynomial = ()
    for degree in degrees:
        if degree <= length:
            rest = _with_cycles(length - degree, degrees)
            result = plus(result, scaled(perm(length - 1, degree - 1), (0, *rest)))
    return result


@cache
def _rising(length: int) -> Polynomial:
    result: Polynomial = (1,)
    for i in range(length):
        result = times(result, (i, 1))
    return result


def rooted_of_genus(edges: int, genus: int) -> dict[int, int]:
    """``{vertices: rooted maps}`` of one genus, by the recurrence of Carrell and Chapuy.

    Raises: ValueError for edges < 1 or genus < 0.
    Source: S. R. Carrell and G. Chapuy, Simple recurrence formulas to count maps on
    orientable surfaces, J. Combin. Theory A 133 (2015).
    """
    check_genus(genus)
    return cells(edges, carrell_chapuy(edges, genus))


def rooted_planar(edges: int) -> dict[int, int]:
    """``{vertices: rooted planar maps}`` with that many edges.

    Raises: ValueError for edges < 1.  Source: as :func:`rooted_of_genus`.
    """
    return rooted_of_genus(edges, 0)


@cache
def carrell_chapuy(n: int, genus: int) -> Polynomial:
    """The polynomial Q_g^n(x) of maps with n edges; their recurrence, times 12."""
    if genus < 0 or 2 * genus > n:
        return ()
    if n == 0:
        return (0, 1)
    bigger = scaled(4 * (2 * n - 1), times((1, 1), carrell_chapuy(n - 1, genus)))
    handle = scaled((2 * n - 3) * (2 * n - 2) * (2 * n - 1), carrell_chapuy(n - 2, genus - 1))
    pairs = [
        scaled(
            6 * (2 * k - 1) * (2 * (n - k) - 1),
            times(carrell_chapuy(k - 1, i), carrell_chapuy(n - k - 1, genus - i)),
        )
        for k in range(1, n)
        for i in range(genus + 1)
    ]
    return divided(plus(bigger, handle, *pairs), 2 * (n + 1))


def rooted_of_genus_by_contraction(edges: int, genus: int) -> dict[int, int]:
    """``{vertices: rooted maps}`` of one genus, by contracting edges at every vertex degree.

    Counted first are maps whose vertices are labelled and have a distinguished dart each;
    of these a rooted map has ``(n-1)!`` times the product of the degrees away from the root.
    Raises: ValueError for edges < 1 or genus < 0.
    Cost: the partitions of 2m, each with the ways to split it in two; meant for m <= 9.
    Source: T. R. S. Walsh and A. B. Lehman, Counting rooted maps by genus I,
    J. Combin. Theory B 13 (1972).
    """
    check_edges(edges)
    check_genus(genus)
    every = frozenset(range(1, 2 * edges + 1))
    return {n: _rooted_by_contraction(edges, n, genus, every) for n in vertex_counts(edges)}


def rooted_of_degrees_by_contraction(edges: int, genus: int, legal: Degrees) -> dict[int, int]:
    """``{vertices: rooted maps}`` of one genus with legal degrees alone.

    Raises, Cost, Source: as :func:`rooted_of_genus_by_contraction`.
    """
    check_genus(genus)
    return {n: _rooted_by_contraction(edges, n, genus, legal) for n in vertex_counts(edges)}


def _rooted_by_contraction(edges: int, vertices: int, genus: int, legal: Degrees) -> int:
    # Each degree of the partition takes the root in turn: sum d / 2m of the orders do.
    scaled = 0
    for degrees in partitions(2 * edges, vertices, 2 * edges):
        if not legal.issuperset(degrees):
            continue
        orders = factorial(vertices) // prod(map(factorial, Counter(degrees).values()))
        weight = 2 * edges * factorial(2 * edges) // prod(degrees)
        scaled += orders * weight * _dotted(degrees[::-1], genus)
    return exactly(scaled, factorial(vertices) * factorial(2 * edges))


@cache
def _dotted(degrees: tuple[int, ...], genus: int) -> int:
    """Maps on labelled vertices of these degrees (rising), each with a distinguished dart."""
    edges = sum(degrees) // 2
    if genus < 0 or len(degrees) - edges + 1 > 2 - 2 * genus:
        return 0
    if degrees[0] == 0:
        return int(degrees == (0,) and genus == 0)
    first, rest = degrees[0], degrees[1:]
    total = 0
    for j, d in enumerate(rest):
        # The distinguished edge of the first vertex leads to any of d darts: contract it.
        merged = sorted((first + d - 2, *rest[:j], *rest[j + 1 :]))
        total += d * _dotted(tuple(merged), genus)
    for a in range(first - 1):
        # It is a loop: split the vertex in two, in a map with a handle less or in two maps.
        b = first - 2 - a
        total += _dotted(tuple(sorted((a, b, *rest))), genus - 1)
        total += _dotted_pairs(a, b, rest, genus)
    return total


def _dotted_pairs(a: int, b: int, rest: tuple[int, ...], genus: int) -> int:
    total = 0
    for size in range(len(rest) + 1):
        for chosen in combinations(range(len(rest)), size):
            left = tuple(sorted((a, *(rest[i] for i in chosen))))
            if sum(left) % 2:
                continue
            right = tuple(sorted((b, *(d for i, d in enumerate(rest) if i not in chosen))))
            total += sum(_dotted(left, g) * _dotted(right, genus - g) for g in range(genus + 1))
    return total
