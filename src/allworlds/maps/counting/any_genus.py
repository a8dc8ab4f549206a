"""Maps of any genus: pairs of permutations, and the recurrences of the literature."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from functools import cache
from itertools import combinations, zip_longest
from math import comb, factorial, perm, prod
from typing import TypeAlias

Degrees: TypeAlias = frozenset[int]
"""The legal degrees of the vertices of a map."""

Polynomial: TypeAlias = tuple[int, ...]
Series: TypeAlias = list[Polynomial]
"""The coefficients of a power series in z, as far as they are needed."""


def vertex_counts(edges: int) -> range:
    """The numbers of vertices that connected maps with ``edges`` edges have.

    Raises: ValueError for edges < 1; and so do all that give ``{vertices: rooted maps}``.
    """
    if edges < 1:
        raise ValueError(f"a map has at least 1 edge, not {edges}")
    return range(1, edges + 2)


def cells(edges: int, polynomial: Polynomial) -> dict[int, int]:
    """The coefficients of a polynomial in x, by the number of vertices."""
    return {n: coefficient(polynomial, n) for n in vertex_counts(edges)}


def partitions(total: int, parts: int, largest: int) -> Iterator[tuple[int, ...]]:
    """The partitions into ``parts`` positive parts, none larger than ``largest``, falling."""
    if parts == 0:
        if total == 0:
            yield ()
        return
    for first in range(min(largest, total - parts + 1), 0, -1):
        if first * parts < total:
            return
        for rest in partitions(total - first, parts - 1, first):
            yield (first, *rest)


def sequences(
    total: int, vertices: int, largest: int, legal: Degrees | None
) -> Iterator[tuple[tuple[int, ...], int]]:
    """The partitions into legal degrees, each with the number of its orders."""
    for degrees in partitions(total, vertices, largest):
        if legal is None or legal.issuperset(degrees):
            orders = factorial(vertices) // prod(map(factorial, Counter(degrees).values()))
            yield degrees, orders


def exactly(numerator: int, denominator: int) -> int:
    """The quotient of two integers; raise ArithmeticError if there is a remainder."""
    quotient, remainder = divmod(numerator, denominator)
    if remainder:
        raise ArithmeticError(f"{numerator} / {denominator} should be a count, but is no integer")
    return quotient


def coefficient(p: Polynomial, power: int) -> int:
    """The coefficient of a power, 0 beyond the last."""
    return p[power] if power < len(p) else 0


def plus(*terms: Polynomial) -> Polynomial:
    """The sum of polynomials."""
    return tuple(map(sum, zip_longest(*terms, fillvalue=0)))


def scaled(factor: int, p: Polynomial) -> Polynomial:
    """A polynomial times an integer."""
    return tuple(factor * c for c in p)


def divided(p: Polynomial, divisor: int) -> Polynomial:
    """A polynomial divided by an integer that divides it."""
    return tuple(exactly(c, divisor) for c in p)


def times(p: Polynomial, q: Polynomial) -> Polynomial:
    """The product of two polynomials."""
    if not p or not q:
        return ()
    result = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return tuple(result)


def series_product(a: Series, b: Series) -> Series:
    """The product of two series cut off alike."""
    return [plus(*(times(a[i], b[k - i]) for i in range(k + 1))) for k in range(len(a))]


def geometric(a: Series) -> Series:
    """The series ``1 / (1 - a)``, where a has no constant term."""
    result: Series = [(1,)]
    for k in range(1, len(a)):
        result.append(plus(*(times(a[i], result[k - i]) for i in range(1, k + 1))))
    return result


def catalan(n: int) -> int:
    """The Catalan number ``C(2n, n) / (n+1)``: rooted plane trees with n edges."""
    return comb(2 * n, n) // (n + 1)


def rooted_maps(edges: int, legal: Degrees | None = None) -> dict[int, int]:
    """``{vertices: rooted maps}`` with that many edges, of any orientable genus.

    With ``legal`` those alone whose degrees are all among these.

    The number is ``2m [z^m x^n] log sum_k (2k-1)!! x(x+1)...(x+2k-1) z^k / (2k)!``: all sigma by
    cycles, times all alpha, on labelled darts; log keeps the connected pairs, and a rooted
    map has ``(2m-1)!`` labellings.  Of legal degrees are those sigma alone whose cycles have legal
    lengths.
    """
    return cells(edges, _connected(edges, legal))


@cache
def _connected(edges: int, legal: Degrees | None) -> Polynomial:
    # With b_k the permutations of 2k darts the sum is A = sum b_k z^k / (2^k k!), and R = 2 z A'/A.
    numerator = scaled(2 * edges, _permutations(2 * edges, legal))
    for k in range(1, edges):
        weight = 2**k * perm(edges, k)
        term = times(_connected(k, legal), _permutations(2 * (edges - k), legal))
        numerator = plus(numerator, scaled(-weight, term))
    return divided(numerator, 2**edges * factorial(edges))


@cache
def _permutations(length: int, legal: Degrees | None) -> Polynomial:
    """Permutations of that many darts by their cycles, whose lengths are legal."""
    result: Polynomial = (1,)
    if legal is None:
        for i in range(length):
            result = times(result, (i, 1))
    elif length:
        result = ()
        for degree in legal:
            if degree <= length:
                rest = _permutations(length - degree, legal)
                result = plus(result, scaled(perm(length - 1, degree - 1), (0, *rest)))
    return result


def rooted_of_genus(edges: int, genus: int) -> dict[int, int]:
    """``{vertices: rooted maps}`` of one genus, by the recurrence of Carrell and Chapuy.

    Source: S. R. Carrell and G. Chapuy, Simple recurrence formulas to count maps on
    orientable surfaces, J. Combin. Theory A 133 (2015).
    """
    return cells(edges, carrell_chapuy(edges, genus))


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


def rooted_of_genus_by_contraction(
    edges: int, genus: int, legal: Degrees | None = None
) -> dict[int, int]:
    """``{vertices: rooted maps}`` of one genus, by contracting edges at every vertex degree.

    With ``legal`` those alone whose degrees are all among these.

    Counted first are maps whose vertices are labelled and have a distinguished dart each;
    of these a rooted map has ``(n-1)!`` times the product of the degrees away from the root.
    Cost: the partitions of 2m, each with the ways to split it in two; meant for m <= 9.
    Source: T. R. S. Walsh and A. B. Lehman, Counting rooted maps by genus I,
    J. Combin. Theory B 13 (1972).
    """
    return {n: _rooted_by_contraction(edges, n, genus, legal) for n in vertex_counts(edges)}


def _rooted_by_contraction(edges: int, vertices: int, genus: int, legal: Degrees | None) -> int:
    # Each degree of the partition takes the root in turn: sum d / 2m of the orders do.
    scaled = 0
    for degrees, orders in sequences(2 * edges, vertices, 2 * edges, legal):
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
