"""The corridor family: worlds in which words that lead home must be tried nearly one by one.

Vertex 0 has degree 2. *Hubs* 1 .. 3F follow, all of degree R = 12F + 6: the first N = 2F are
*near*, the others *far*. Consecutive vertices are joined by two parallel edges, from the
*out-darts* of one to the *in-darts* of the next. In hub l the in-darts have the numbers 0 and 1,
the out-darts -4l and -4l - 2 modulo R; so the four motions from an out-dart to an in-dart are the
*class* {4l, 4l + 1, 4l + 2, 4l + 3} of the hub, and classes of different hubs are disjoint. The
other darts of near hubs are loops, and the other 2M darts of far hubs, the *open* darts, can be
matched in any way: n = 3F + 1, m = 18F^2 + 9F + 1, M = 6F^2 + F + 1.

Source: ``docs/theory.md``, 'Lower bounds'.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from random import Random

from allworlds.maps.combinatorial import CombinatorialMap


def corridor_degree(far: int) -> int:
    """The degree R of every hub."""
    return 12 * far + 6


def corridor_edges(far: int) -> int:
    """The number of edges m."""
    return 18 * far * far + 9 * far + 1


def apart(hub: int) -> tuple[int, int]:
    """The out-darts of a hub as motions from its first in-dart; classes of hubs are disjoint."""
    return -4 * hub, -4 * hub - 2


@dataclass(frozen=True, slots=True)
class Corridor:
    """A world of the family before its open darts are matched.

    Attributes:
        far: F, the number of far hubs.
        sigma: the rotations; vertex 0 has darts 0 and 1, hub l those from 2 + (l - 1)R on.
        alpha: the fixed edges; ``alpha[d] == d`` marks an open dart.
        open: the open darts, in the order in which they are matched in pairs at first.
    """

    far: int
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    open: tuple[int, ...]

    @property
    def degree(self) -> int:
        """The degree R of every hub."""
        return corridor_degree(self.far)

    def level(self, dart: int) -> int:
        """The number of the dart's vertex: 0, or that of its hub."""
        return 0 if dart < 2 else 1 + (dart - 2) // self.degree

    def turned(self, dart: int, motion: int) -> int:
        """The dart that is ``motion`` places on, clockwise, at the same vertex."""
        if dart < 2:
            return (dart + motion) % 2
        place = (dart - 2) % self.degree
        return dart - place + (place + motion) % self.degree

    def matched(self, partners: Sequence[tuple[int, int]]) -> CombinatorialMap:
        """The map with these edges between the open darts."""
        alpha = list(self.alpha)
        for d, e in partners:
            alpha[d], alpha[e] = e, d
        return CombinatorialMap(self.sigma, tuple(alpha))


def corridor_skeleton(
    far: int, random: Random, outs: Callable[[int], tuple[int, int]] = apart
) -> Corridor:
    """A corridor with drawn near loops, and its open darts in a drawn order.

    Args:
        far: F.
        random: the source of all that is drawn.
        outs: the out-darts of a hub; others than :func:`apart` break the lemmas.

    Raises:
        ValueError: for F < 1.
    """
    if far < 1:
        raise ValueError("F is at least 1")
    degree, hubs = corridor_degree(far), 3 * far
    sigma, alpha = [1, 0], list(range(2 + hubs * degree))
    free: list[int] = []

    def join(d: int, e: int) -> None:
        alpha[d], alpha[e] = e, d

    join(0, 2)
    join(1, 3)
    for hub in range(1, hubs + 1):
        base = 2 + (hub - 1) * degree
        sigma += [*range(base + 1, base + degree), base]
        fixed = {base, base + 1}
        if hub < hubs:
            for k, out in enumerate(outs(hub)):
                dart = base + out % degree
                fixed.add(dart)
                join(dart, base + degree + k)
        rest = [d for d in range(base, base + degree) if d not in fixed]
        if hub <= 2 * far:
            random.shuffle(rest)
            for d, e in zip(rest[::2], rest[1::2], strict=True):
                join(d, e)
        else:
            free += rest
    random.shuffle(free)
    return Corridor(far, tuple(sigma), tuple(alpha), tuple(free))


def drawn_corridor(far: int, seed: int) -> Corridor:
    """The corridor with F far hubs that a seed draws."""
    return corridor_skeleton(far, Random(f"corridor/{far}/{seed}"))  # noqa: S311  # reproducible


def corridor(far: int, seed: int) -> CombinatorialMap:
    """The world with F far hubs, near loops and far matching drawn."""
    drawn = drawn_corridor(far, seed)
    return drawn.matched(list(zip(drawn.open[::2], drawn.open[1::2], strict=True)))


def bound_of_testers(far: int) -> int:
    """The traversals that every explorer that tests hypotheses by words that lead home needs.

    Of each such explorer the adversary makes a world of the family in which it does:
    2(F + 1)(M^2 - M - 4MF).

    Source: ``docs/theory.md``, 'Lower bounds'.
    """
    half = 6 * far * far + far + 1
    return 2 * (far + 1) * (half * half - half - 4 * half * far)
