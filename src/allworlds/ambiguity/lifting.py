"""Every cover of a quotient in which one vertex lies over the root's vertex."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import permutations
from typing import TypeAlias

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.maps.quotient import Quotient

Permutation: TypeAlias = tuple[int, ...]
"""Of the sheets ``0..k-1``."""


def lifts(quotient: Quotient) -> Iterator[CombinatorialMap]:
    """A map for each way to permute the sheets (:mod:`allworlds.ambiguity.criterion`).

    Dart ``q * k + i`` of a map lies over class q, in sheet i.  The sheets keep their names
    round each vertex up to its last class, and along a spanning tree.  The same marked map
    comes up to k times, once for each dart over class 0 that its automorphisms do not carry
    to another.

    Cost: O(m) a map, and O(m) memory.
    """
    k = quotient.sheets
    others = quotient.vertices[1:]
    kinds: list[Callable[[], Iterator[Permutation]]] = []
    for b in quotient.cone_indices[1:]:
        kinds.append(lambda b=b: uniform_permutations(k, b))  # type: ignore[misc]
    kinds += [lambda: uniform_permutations(k, 2)] * len(quotient.semi_edges)
    kinds += [lambda: permutations(range(k))] * len(quotient.cotree)
    turn = (*range(1, k), 0)
    for choice in _choices(kinds):
        round_vertex = [turn, *choice[: len(others)]]
        across = choice[len(others) :]
        yield _lift(quotient, round_vertex, across)


def _lift(
    quotient: Quotient, round_vertex: Sequence[Permutation], across: Sequence[Permutation]
) -> CombinatorialMap:
    k = quotient.sheets
    sigma = [q * k + i for q in quotient.sigma for i in range(k)]
    alpha = [q * k + i for q in quotient.alpha for i in range(k)]
    for vertex, moved in zip(quotient.vertices, round_vertex, strict=True):
        _permute(sigma, k, vertex[-1], vertex[0], moved)
    semi, ordinary = across[: len(quotient.semi_edges)], across[len(quotient.semi_edges) :]
    for q, moved in zip(quotient.semi_edges, semi, strict=True):
        _permute(alpha, k, q, q, moved)
    for (q, other), moved in zip(quotient.cotree, ordinary, strict=True):
        _permute(alpha, k, q, other, moved)
        _permute(alpha, k, other, q, sorted(range(k), key=moved.__getitem__))
    return CombinatorialMap.trusted(sigma, alpha)


def _permute(map_: list[Dart], k: int, q: int, to: int, moved: Sequence[int]) -> None:
    """Let the darts over class q go to those over class ``to``, sheets moved."""
    map_[q * k : (q + 1) * k] = [to * k + i for i in moved]


def _choices(
    kinds: Sequence[Callable[[], Iterator[Permutation]]],
) -> Iterator[tuple[Permutation, ...]]:
    """One of each kind, in lexicographic order; unlike a product, nothing is stored."""
    if not kinds:
        yield ()
        return
    for first in kinds[0]():
        for rest in _choices(kinds[1:]):
            yield (first, *rest)


def uniform_permutations(k: int, b: int) -> Iterator[Permutation]:
    """The permutations of ``0..k-1`` all of whose cycles have length b; none if b divides not.

    Cost: O(k) each.
    """
    to = [-1] * k

    def filled() -> Iterator[Permutation]:
        if -1 not in to:
            yield tuple(to)
            return
        first = to.index(-1)
        free = [x for x in range(first + 1, k) if to[x] == -1]
        for rest in permutations(free, b - 1):
            cycle = (first, *rest)
            for x, y in zip(cycle, (*rest, first), strict=True):
                to[x] = y
            yield from filled()
            for x in cycle:
                to[x] = -1

    yield from filled()
