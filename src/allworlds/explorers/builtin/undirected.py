"""Algorithm 1 without a direction: with two vertices that can be recognised, v0 and v1.

One edge joins v0 and v1, and the dart of v0 that leads to v1 stands for the pointed dart of a
directional lighthouse.  It is searched first.  Where Algorithm 1 compares a bearing, at the end
of a test that has come to v0, the robot leaves by the dart that should lead to v1, looks, and
comes back: the *query*, two traversals.  A hypothesis at v0 is tested by the query alone.

The choices are those of Algorithm 1.  Source: Sections IV and VIII of the paper; that it is right
if exactly one edge joins v0 and v1 is proved in ``proofs/coq`` (TwoVertices).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from allworlds.explorers.builtin.algorithm1 import Algorithm1, Walk, nobody
from allworlds.protocol.actions import Move, Percept
from allworlds.protocol.answers import Estimate
from allworlds.protocol.choices import Choices

Recognised: TypeAlias = Callable[[Percept], bool]
"""Whether a percept is that of one certain vertex."""


def algorithm1_cluster(
    first: Percept,
    *,
    choices: Choices | None = None,
    notice: Callable[[str], None] = nobody,
) -> Walk[Estimate]:
    """Explore from a marker cluster: one marker lies at v0, two at v1.

    Choices and events are those of Algorithm 1.

    Cost: at most (1) + (2), 2 traversals a test, and 2 deg(v0) for the search.
    """
    explorer = TwoVertices(
        first,
        lambda seen: seen.marks == 1,
        lambda seen: seen.marks == 2,
        choices or Choices(),
        notice,
    )
    return (yield from explorer.explore())


def algorithm1_natural(
    first: Percept,
    *,
    choices: Choices | None = None,
    told: int | None = None,
    notice: Callable[[str], None] = nobody,
) -> Walk[Estimate]:
    """Explore from a natural lighthouse: no other vertex has the degree of v0, or that of v1.

    It is told the degree of v1; choices and events are those of Algorithm 1.

    Cost: as for :func:`algorithm1_cluster`.
    """
    explorer = TwoVertices(
        first,
        lambda seen: seen.degree == first.degree,
        lambda seen: seen.degree == told,
        choices or Choices(),
        notice,
    )
    return (yield from explorer.explore())


class TwoVertices(Algorithm1):
    """An exploration from v0, whose neighbour v1 is recognised too.

    Attributes:
        is_v0, is_v1: whether a percept is that of v0, or of v1.
        pointed: the dart of v0 that leads to v1, in S; known after the search.
    """

    def __init__(
        self,
        first: Percept,
        is_v0: Recognised,
        is_v1: Recognised,
        choices: Choices,
        notice: Callable[[str], None] = nobody,
    ) -> None:
        self.is_v0, self.is_v1 = is_v0, is_v1
        super().__init__(first, choices, notice)
        self.pointed = 0

    def explore(self) -> Walk[Estimate]:
        """Search the dart to v1, then explore by Algorithm 1."""
        yield from self.search()
        return (yield from super().explore())

    def search(self) -> Walk[None]:
        """Try the darts of v0, from the dart faced on clockwise, until one leads to v1.

        If none does, the promise of the lighthouse is broken.  The last dart is taken then, and no
        query will ever be answered by v1.
        """
        for dart in list(self.s.unexplored):
            seen = yield Move(dart - self.here)
            yield Move(0)
            self.here = self.pointed = dart
            if self.is_v1(seen):
                return

    def reads(self, percept: Percept) -> Percept:
        """The part of a percept that is compared: the degree, and whether it is v0's."""
        return Percept(percept.degree, int(self.is_v0(percept)))

    def try_path(self, partner: int, path: list[int]) -> Walk[tuple[list[int], bool]]:
        """Lines 10-13, and the query at v0, after which the robot is turned towards v1."""
        motions, matched = yield from super().try_path(partner, path)
        if matched:
            towards = self.s.offset(super().confirmed_at(partner, path), self.pointed)
            seen = yield Move(towards - self.turned)
            yield Move(0)
            self.turned = towards
            matched = self.is_v1(seen)
        return motions, matched

    def confirmed_at(self, partner: int, path: list[int]) -> int:  # noqa: ARG002  # any path
        """The pointed dart, by which the query has led back."""
        return self.pointed
