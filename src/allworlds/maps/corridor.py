"""The corridor family: worlds in which words that lead home must be tried nearly one by one.

Vertex 0 has degree 2.  *Hubs* 1, 2, ... follow, all of the even degree R: the first N are *near*,
the last F are *far*.  Consecutive vertices are joined by two parallel edges, from the *out-darts*
of one to the *in-darts* of the next.  In each hub the in-darts have the numbers 0 and 1, and the
out-darts -4c and -4c - 2 modulo R, where c is the *type* of the hub; so the four motions from an
out-dart to an in-dart are the *class* {4c, 4c + 1, 4c + 2, 4c + 3}, and classes of different types
are disjoint.  The other darts of near hubs are loops.  The other darts of far hubs, 2M in number,
are *free*: they can be matched in any way.

There are q = floor((R - 6) / 4) types, and the *window* g is the least positive number for which no
g consecutive hubs among N = (g + 1)F have the same types as g others: q^g >= N.  For R >= 8F + 6
all near hubs differ: g = 1 and N = 2F.  In all

    n = N + F + 1,  m = (N + F)R/2 + 1,  M = F(R - 4)/2 + 1.

Source: ``papers/lower_bounds/lower-bounds.md``, 'Testers of home words'.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import cycle, islice
from random import Random

from msgspec import Struct

from allworlds.maps.combinatorial import CombinatorialMap

LEAST_DEGREE = 14
"""The least degree of a hub: with two types, and more free darts than testers get for nothing."""


def usual_degree(far: int) -> int:
    """The degree of hubs where none is named: 12F + 6, so that all hubs have different types."""
    return 12 * far + 6


def apart(kind: int) -> tuple[int, int]:
    """The out-darts of a hub of some type; classes of different types are disjoint."""
    return -4 * kind, -4 * kind - 2


class CorridorShape(Struct, frozen=True):
    """The numbers of a corridor.

    Attributes:
        far: F, the number of far hubs.
        degree: R, the degree of every hub.

    Raises:
        ValueError: for F < 1, an odd R, or R < 14.
    """

    far: int
    degree: int

    def __post_init__(self) -> None:
        """Check the numbers."""
        if self.far < 1 or self.degree < LEAST_DEGREE or self.degree % 2:
            raise ValueError(f"F is at least 1, R even and at least {LEAST_DEGREE}")

    @property
    def types(self) -> int:
        """The number q of types of hubs."""
        return (self.degree - 6) // 4

    @property
    def window(self) -> int:
        """The number g of consecutive near hubs whose types tell which ones they are."""
        window = 1
        while self.types**window < (window + 1) * self.far:
            window += 1
        return window

    @property
    def near(self) -> int:
        """The number N of near hubs."""
        return (self.window + 1) * self.far

    @property
    def hubs(self) -> int:
        """The number of all hubs."""
        return self.near + self.far

    @property
    def edges(self) -> int:
        """The number m of edges."""
        return self.hubs * self.degree // 2 + 1


class Corridor(Struct, frozen=True):
    """A world of the family before its free darts are matched.

    Attributes:
        shape: its numbers.
        sigma: the rotations; vertex 0 has darts 0 and 1, hub l those from 2 + (l - 1)R on.
        alpha: the fixed edges; ``alpha[d] == d`` marks a free dart.
        free: the free darts, in the order in which they are matched in pairs at first.
    """

    shape: CorridorShape
    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    free: tuple[int, ...]

    def matched(self, partners: Sequence[tuple[int, int]]) -> CombinatorialMap:
        """The map with these edges between the free darts."""
        alpha = list(self.alpha)
        for d, e in partners:
            alpha[d], alpha[e] = e, d
        return CombinatorialMap(self.sigma, tuple(alpha))


def corridor_skeleton(
    shape: CorridorShape, random: Random, outs: Callable[[int], tuple[int, int]] = apart
) -> Corridor:
    """A corridor with drawn near loops, and its free darts in a drawn order.

    Args:
        shape: its numbers.
        random: the source of all that is drawn.
        outs: the out-darts of a hub of some type; others than :func:`apart` break the lemmas.
    """
    degree = shape.degree
    sigma, alpha = [1, 0], list(range(2 + shape.hubs * degree))
    free: list[int] = []

    def join(d: int, e: int) -> None:
        alpha[d], alpha[e] = e, d

    join(0, 2)
    join(1, 3)
    for hub, kind in enumerate(hub_types(shape), 1):
        base = 2 + (hub - 1) * degree
        sigma += [*range(base + 1, base + degree), base]
        fixed = {base, base + 1}
        if hub < shape.hubs:
            for k, out in enumerate(outs(kind)):
                dart = base + out % degree
                fixed.add(dart)
                join(dart, base + degree + k)
        rest = [d for d in range(base, base + degree) if d not in fixed]
        if hub <= shape.near:
            random.shuffle(rest)
            for d, e in zip(rest[::2], rest[1::2], strict=True):
                join(d, e)
        else:
            free += rest
    random.shuffle(free)
    return Corridor(shape, tuple(sigma), tuple(alpha), tuple(free))


def hub_types(shape: CorridorShape) -> Iterator[int]:
    """The type 1..q of each hub; no g consecutive near hubs have the types of g others."""
    return islice(cycle(_de_bruijn(shape.types, shape.window)), shape.hubs)


def _de_bruijn(letters: int, length: int) -> Iterator[int]:
    """The least word over 1..letters that holds each word of that length once, read as a ring.

    Source: H. Fredricksen, J. Maiorana, Necklaces of beads in k colors and k-ary de Bruijn
    sequences, Discrete Math. 23 (1978): Lyndon words whose lengths divide that length, ascending.
    """
    word = [0]
    while word:
        if length % len(word) == 0:
            yield from (letter + 1 for letter in word)
        word = list(islice(cycle(word), length))
        while word and word[-1] == letters - 1:
            word.pop()
        if word:
            word[-1] += 1


def drawn_corridor(shape: CorridorShape, seed: int) -> Corridor:
    """The corridor of that shape that a seed draws."""
    name = f"corridor/{shape.far}/{seed}"
    if shape.degree != usual_degree(shape.far):
        name = f"corridor/{shape.far}x{shape.degree}/{seed}"
    return corridor_skeleton(shape, Random(name))  # noqa: S311  # reproducible


def corridor(far: int, degree: int, seed: int) -> CombinatorialMap:
    """The world with F far hubs of degree R, near loops and far matching drawn."""
    drawn = drawn_corridor(CorridorShape(far, degree), seed)
    return drawn.matched(list(zip(drawn.free[::2], drawn.free[1::2], strict=True)))


def corridor_edges(far: int, degree: int) -> int:
    """The number of edges m; 0 where there is no such corridor."""
    try:
        return CorridorShape(far, degree).edges
    except ValueError:
        return 0
