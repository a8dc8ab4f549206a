"""Maps with one marked vertex: their canonical codes and their symmetries."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from allworlds.maps import Code, CombinatorialMap, Dart, rooted_code


class LeastRooting(NamedTuple):
    """The least code among some rootings of a map, and how many of them have it."""

    code: Code
    times: int


def least_rooting(map_: CombinatorialMap, darts: Sequence[Dart]) -> LeastRooting:
    """The canonical key of the map with the vertex of ``darts`` marked.

    ``darts`` are all darts of the vertex, or all those that look alike to a robot there: an
    isomorphism of marked maps carries the ones to the ones.  ``times`` is the number of
    automorphisms that fix the marked vertex.

    Cost: O(m) for each dart.
    """
    codes = [rooted_code(map_.sigma, map_.alpha, dart) for dart in darts]
    least = min(codes)
    return LeastRooting(least, codes.count(least))


def is_least_rooting(map_: CombinatorialMap) -> bool:
    """Whether no other dart at the vertex of dart 0 has a smaller code.

    One rooted map of each marked map passes.  Cost: O(m deg) at worst.
    """
    sigma, alpha = map_.sigma, map_.alpha
    code = rooted_code(sigma, alpha, 0)
    dart = sigma[0]
    while dart:
        if rooted_code(sigma, alpha, dart) < code:
            return False
        dart = sigma[dart]
    return True
