"""Points on the curves of edges, and the distance between two curves."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

ROUND_VERTEX, ROUND_CROSSING = 40.0, 30.0
"""In pixels: so near to a vertex or to a crossing of theirs edges may come near each other."""


def points_of(way: Sequence[complex]) -> list[complex]:
    """Points of the curve: its ends, the tops of its parabolas, and the points where these meet."""
    points = [way[0], (way[0] + way[1]) / 2]
    for a, b, c in zip(way, way[1:], way[2:], strict=False):
        points += [(a + 6 * b + c) / 8, (b + c) / 2]
    return [*points, way[-1]]


def crossings_of(way: Sequence[complex]) -> Sequence[complex]:
    """The points where the edge crosses an edge: every fifth point between its ends."""
    return way[5:-1:5]


def bridges_of(way: Sequence[complex]) -> list[tuple[complex, complex]]:
    """The ends of the straight piece of the curve about each crossing."""
    around = zip(way[4::5], crossings_of(way), way[6::5], strict=False)
    return [((before + at) / 2, (at + after) / 2) for before, at, after in around]


def least_distance(ways: Sequence[Sequence[complex]]) -> float:
    """The smallest distance of two edges in pixels, apart from vertices and crossings.

    Args:
        ways: for each dart the points that its edge is drawn towards.

    Cost: quadratic in the number of points; these are so dense that the distance is about right.
    """
    ends = [way[0] for way in ways]
    crossed = [point for way in ways for point in crossings_of(way)]
    free = {}
    for way in ways:
        # Each edge has two darts; seen from the other one its points are those backwards.
        name = min((p.real, p.imag) for p in (way[1], way[-2]))
        free[name] = [
            p
            for p in points_of(way)
            if all(abs(p - end) > ROUND_VERTEX for end in ends)
            and all(abs(p - end) > ROUND_CROSSING for end in crossed)
        ]
    return min(
        (abs(p - q) for one, other in combinations(free.values(), 2) for p in one for q in other),
        default=float("inf"),
    )
