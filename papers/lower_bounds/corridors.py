"""Corridors: their numbers, and which of their darts can be matched in any way.

The family is told in ``lower-bounds.md``, 'Testers of home words'; its worlds are those of
``allworlds.maps.family("corridor:FxR")``.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, TypeAlias

from allworlds import CombinatorialMap
from allworlds.maps import CorridorShape, family, usual_degree

Dart: TypeAlias = int


class Shape(CorridorShape, frozen=True):
    """The numbers of a corridor, and what is proved of it."""

    @property
    def pairs(self) -> int:
        """The number M of edges between free darts."""
        return self.far * (self.degree - 4) // 2 + 1

    @property
    def excluded_by_testers(self) -> int:
        """The number of pairs of free darts that the tests of a tester exclude, at least."""
        return self.pairs * (self.pairs - 1 - 4 * self.far)

    @property
    def bound_of_testers(self) -> int:
        """The traversals that every tester needs in the world that the adversary makes of it."""
        private = self.near - self.far - self.window + 2
        return 2 * private * self.excluded_by_testers

    def level(self, dart: Dart) -> int:
        """The number of the dart's vertex: 0, or that of its hub."""
        return 0 if dart < 2 else 1 + (dart - 2) // self.degree


def usual_shape(far: int) -> Shape:
    """The corridor with so many far hubs whose hubs all have different types: of degree 12F + 6."""
    return Shape(far, usual_degree(far))


class Corridor(NamedTuple):
    """A world of the family without the edges between its free darts.

    Attributes:
        shape: its numbers.
        sigma: the rotations.
        alpha: the fixed edges; ``alpha[d] == d`` marks a free dart.
        free: the free darts; neighbours in pairs are matched at first.
    """

    shape: Shape
    sigma: tuple[Dart, ...]
    alpha: tuple[Dart, ...]
    free: tuple[Dart, ...]

    def turned(self, dart: Dart, motion: int) -> Dart:
        """The dart that is ``motion`` places on, clockwise, at the same vertex."""
        if dart < 2:
            return (dart + motion) % 2
        place = (dart - 2) % self.shape.degree
        return dart - place + (place + motion) % self.shape.degree

    def matched(self, partners: Iterable[tuple[Dart, Dart]]) -> CombinatorialMap:
        """The map with these edges between the free darts."""
        alpha = list(self.alpha)
        for d, e in partners:
            alpha[d], alpha[e] = e, d
        return CombinatorialMap(self.sigma, alpha)


def drawn_corridor(shape: Shape, seed: int) -> Corridor:
    """The corridor of that shape that a seed draws: the edges of far hubs to hubs are fixed."""
    map_ = family(f"corridor:{shape.far}x{shape.degree}", seed=seed)
    hubs = range(2, len(map_.sigma), shape.degree)
    entered = [first + side for first in hubs for side in (0, 1)]
    fixed = {*entered, *(map_.alpha[dart] for dart in entered)}
    free = [
        end
        for dart in map_.darts
        if shape.level(dart) > shape.near and dart not in fixed and dart < map_.alpha[dart]
        for end in (dart, map_.alpha[dart])
    ]
    alpha = [dart if dart in free else other for dart, other in enumerate(map_.alpha)]
    return Corridor(shape, map_.sigma, tuple(alpha), tuple(free))
