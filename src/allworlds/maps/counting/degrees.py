"""Simple maps, all of them: labelled graphs by their degree sequences."""

from __future__ import annotations

from collections import Counter
from functools import cache
from itertools import product
from math import comb, factorial, prod

from allworlds.maps.counting.any_genus import Degrees
from allworlds.maps.counting.arithmetic import exactly, partitions, vertex_counts


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
