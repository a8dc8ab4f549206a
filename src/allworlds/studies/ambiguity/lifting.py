"""Covers of a quotient in which exactly one vertex lies over the root's vertex: all of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import permutations
from typing import TypeAlias

from allworlds.maps import CombinatorialMap, Dart, Quotient

Permutation: TypeAlias = tuple[int, ...]
"""Of the sheets ``0..k-1``."""

_Kind: TypeAlias = Callable[[Sequence[tuple[int, ...]]], Iterator[tuple[int, ...]]]


def lifts(quotient: Quotient) -> Iterator[CombinatorialMap]:
    """A map for each way to permute the sheets (:mod:`allworlds.maps.criterion`).

    Dart ``q * k + i`` of a map lies over class q, in sheet i.  The sheets keep their names
    round each vertex up to its last class, and along a spanning tree.  The same marked map
    comes up to k times, once for each dart over class 0 that its automorphisms do not carry
    to another.

    Cost: O(m) a map, and O(m) memory.
    """
    k = quotient.sheets
    others = quotient.cone_indices[1:]
    kinds: list[_Kind] = [
        partial(_uniform, k, b) for b in (*others, *[2] * len(quotient.semi_edges))
    ]
    kinds += [partial(_any, k)] * len(quotient.cotree)
    turn = (*range(1, k), 0)
    for choice in _choices(kinds):
        round_vertex = (turn, *choice[: len(others)])
        yield _lift(quotient, round_vertex, choice[len(others) :])


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


def uniform_permutations(k: int, b: int) -> Iterator[Permutation]:
    """The permutations of ``0..k-1`` all of whose cycles have length b; none if b divides not.

    Cost: O(k) each, up to what their cycles have in common.
    """
    if k % b:
        return

    def next_cycle(cycles: Sequence[tuple[int, ...]]) -> Iterator[tuple[int, ...]]:
        used = {x for cycle in cycles for x in cycle}
        first, *free = (x for x in range(k) if x not in used)
        return ((first, *rest) for rest in permutations(free, b - 1))

    for cycles in _choices([next_cycle] * (k // b)):
        moved = [0] * k
        for cycle in cycles:
            for x, y in zip(cycle, (*cycle[1:], cycle[0]), strict=True):
                moved[x] = y
        yield tuple(moved)


def _uniform(k: int, b: int, _before: object) -> Iterator[Permutation]:
    return uniform_permutations(k, b) if b > 1 else iter([tuple(range(k))])


def _any(k: int, _before: object) -> Iterator[Permutation]:
    return permutations(range(k))


def _choices(kinds: Sequence[_Kind]) -> Iterator[tuple[tuple[int, ...], ...]]:
    """Every combination with one option of each kind, in lexicographic order.

    Each kind is given the options chosen before.

    Unlike a product nothing is stored, and unlike a recursion the kinds may be thousands.
    """
    chosen: list[tuple[int, ...]] = []
    open_kinds: list[Iterator[tuple[int, ...]]] = []
    while True:
        if len(chosen) == len(kinds):
            yield tuple(chosen)
        else:
            open_kinds.append(kinds[len(chosen)](chosen))
        while open_kinds:
            del chosen[len(open_kinds) - 1 :]
            following = next(open_kinds[-1], None)
            if following is not None:
                chosen.append(following)
                break
            open_kinds.pop()
        else:
            return
