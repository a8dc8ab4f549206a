"""Bouquets at a distance: v0 of degree 1, joined to a vertex with loops, matched in every way.

Source: ``docs/theory.md``, 'Explorers that never forget' and 'Lower bounds that are proved in Coq'.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from math import prod

from allworlds import CombinatorialMap, Percept, World

MANY = 10**12
"""More than the worlds of any search."""


def bouquets(loops: int) -> Iterator[World]:
    """Every bouquet with that many loops; the robot and the marker are at the dart of v0."""
    size = 2 * loops + 2
    for pairs in _matchings(range(2, size)):
        alpha = [1, 0, *range(2, size)]
        for d, e in pairs:
            alpha[d], alpha[e] = e, d
        yield World(CombinatorialMap((0, *range(2, size), 1), alpha), "directional")


def number_of_bouquets(loops: int) -> int:
    """The number of bouquets with that many loops: (2c-1)!!."""
    return prod(range(1, 2 * loops, 2))


def _matchings(darts: Sequence[int]) -> Iterator[list[tuple[int, int]]]:
    if not darts:
        yield []
        return
    first, *others = darts
    for other in others:
        rest = [dart for dart in others if dart != other]
        for pairs in _matchings(rest):
            yield [(first, other), *pairs]


def told_apart(percept: Percept, left: int) -> int:
    """The number of bouquets that so many traversals tell apart, after a percept, at most.

    The two motions after a visit to v0 show nothing.
    """
    return _from_hub(max(left - 2, 0) if percept.marks else left)


@cache
def _from_hub(left: int) -> int:
    """f(0), f(1), f(2) = 1, 2, 3, and f(b) = f(b-1) + f(b-3); of many no more than MANY."""
    if left < 3:
        return left + 1
    return min(MANY, _from_hub(left - 1) + _from_hub(left - 3))


def bound_of_information(worlds: int) -> int:
    """The fewest traversals that can tell so many bouquets apart."""
    left = 0
    while told_apart(Percept(1, 1, 0), left) < worlds:
        left += 1
    return left


def cautious_cost(loops: int) -> int:
    """The worst cost of an explorer that tests one hypothesis after the other: c(2c+1)."""
    return loops * (2 * loops + 1)
