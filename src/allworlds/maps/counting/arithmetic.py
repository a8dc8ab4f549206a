"""Exact arithmetic of the counts: polynomials, series cut off alike, partitions.

A polynomial is a tuple of integer coefficients, lowest power first.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest
from typing import TypeAlias

Polynomial: TypeAlias = tuple[int, ...]
Series: TypeAlias = list[Polynomial]
"""The coefficients of a power series in z, as far as they are needed."""


def check_edges(edges: int) -> None:
    """Raise ValueError unless the number of edges is at least 1."""
    if edges < 1:
        raise ValueError(f"a map has at least 1 edge, not {edges}")


def check_genus(genus: int) -> None:
    """Raise ValueError if the genus is negative."""
    if genus < 0:
        raise ValueError(f"a genus is at least 0, not {genus}")


def vertex_counts(edges: int) -> range:
    """The numbers of vertices that connected maps with ``edges`` edges have."""
    check_edges(edges)
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
