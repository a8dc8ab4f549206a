"""All small maps by trying every permutation: slow, short, and the yardstick of the fast ones."""

from __future__ import annotations

from functools import cache
from itertools import permutations
from math import factorial
from typing import TYPE_CHECKING, TypeAlias

from allworlds.maps.combinatorial import CombinatorialMap

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

_Code: TypeAlias = tuple[tuple[int, ...], tuple[int, ...]]

_MOST_EDGES = 5


def rooted_maps_by_permutations(
    edges: int, map_class: str = "maps"
) -> tuple[CombinatorialMap, ...]:
    """Every rooted map with ``edges`` edges once, canonically numbered with root 0, by code.

    Canonically numbered: the root is 0, and taking the darts in the order of their numbers,
    first sigma of the dart and then alpha of it gets the next number if it has none.  The
    code is the pair ``(sigma, alpha)`` in these numbers; the order is lexicographic.

    Args:
        edges: m, from 1 to 5.
        map_class: one of :class:`~allworlds.maps.classes.MapClass`.

    Raises:
        ValueError: for a number of edges out of range, or an unknown class.

    Cost: O((2m)! m) for the first call with a given m; it is kept.
    """
    return _as_maps(code for rootings in _classes(edges, map_class) for code in rootings)


def unrooted_maps(edges: int, map_class: str = "maps") -> tuple[CombinatorialMap, ...]:
    """Every map with ``edges`` edges once: the least code among its rootings, by code.

    Two maps are the same if a bijection of darts commutes with sigma and alpha; mirror
    images are two maps unless they are the same in this sense.

    Args, Raises, Cost: as :func:`rooted_maps_by_permutations`.
    """
    return _as_maps(min(rootings) for rootings in _classes(edges, map_class))


def _as_maps(codes: Iterable[_Code]) -> tuple[CombinatorialMap, ...]:
    return tuple(CombinatorialMap(sigma, alpha) for sigma, alpha in sorted(codes))


def _classes(edges: int, map_class: str) -> list[frozenset[_Code]]:
    """For each map of the class the codes of all its rootings."""
    if map_class not in _LAWS:
        raise ValueError(f"{map_class!r} is no class of maps; classes are {', '.join(_LAWS)}")
    if edges < 1:
        raise ValueError(f"a map has at least 1 edge, not {edges}")
    if edges > _MOST_EDGES:
        raise ValueError(
            f"{edges} edges would take (2m)! = {factorial(2 * edges)} permutations; "
            f"trying all of them is for at most {_MOST_EDGES} edges"
        )
    laws = _LAWS[map_class]
    return [
        rootings
        for rootings in _all_classes(edges)
        if all(law(*next(iter(rootings))) for law in laws)
    ]


@cache
def _all_classes(edges: int) -> tuple[frozenset[_Code], ...]:
    # Every map can be renumbered so that its edges are 01, 23, ...: one alpha is enough.
    # A code that is known, of any rooting, means that the map is known with all of them.
    darts = range(2 * edges)
    alpha = [dart ^ 1 for dart in darts]
    known: set[_Code] = set()
    classes = []
    for sigma in permutations(darts):
        order = _numbering(sigma, alpha, 0)
        if len(order) < len(darts) or _code(sigma, alpha, order) in known:
            continue
        rootings = frozenset(_code(sigma, alpha, _numbering(sigma, alpha, root)) for root in darts)
        known |= rootings
        classes.append(rootings)
    return tuple(classes)


def _numbering(sigma: Sequence[int], alpha: Sequence[int], root: int) -> list[int]:
    """The darts that can be reached from the root, in the order of their canonical numbers."""
    order = [root]
    numbered = {root}
    for dart in order:
        for neighbour in (sigma[dart], alpha[dart]):
            if neighbour not in numbered:
                numbered.add(neighbour)
                order.append(neighbour)
    return order


def _code(sigma: Sequence[int], alpha: Sequence[int], order: Sequence[int]) -> _Code:
    number = {dart: i for i, dart in enumerate(order)}
    return (
        tuple(number[sigma[dart]] for dart in order),
        tuple(number[alpha[dart]] for dart in order),
    )


def _orbit(permutation: Sequence[int], dart: int) -> frozenset[int]:
    orbit = {dart}
    while (dart := permutation[dart]) not in orbit:
        orbit.add(dart)
    return frozenset(orbit)


def _is_simple(sigma: Sequence[int], alpha: Sequence[int]) -> bool:
    """Whether no edge is a loop, and there are as many joined pairs of vertices as edges."""
    vertex = [_orbit(sigma, dart) for dart in range(len(sigma))]
    joined = {frozenset((vertex[dart], vertex[alpha[dart]])) for dart in range(len(sigma))}
    return len(joined) == len(sigma) // 2 and all(len(ends) == 2 for ends in joined)


def _is_planar(sigma: Sequence[int], alpha: Sequence[int]) -> bool:
    """Whether Euler's formula of the sphere holds: vertices - edges + faces = 2."""
    darts = range(len(sigma))
    vertices = {_orbit(sigma, dart) for dart in darts}
    walk = [sigma[alpha[dart]] for dart in darts]
    faces = {_orbit(walk, dart) for dart in darts}
    return len(vertices) - len(sigma) // 2 + len(faces) == 2


_LAWS: dict[str, tuple[Callable[[Sequence[int], Sequence[int]], bool], ...]] = {
    "maps": (),
    "simple": (_is_simple,),
    "planar": (_is_planar,),
    "planar-simple": (_is_planar, _is_simple),
}
