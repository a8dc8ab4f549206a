"""Minimax over given worlds: bounds from both sides, and a strategy."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from functools import partial
from typing import TYPE_CHECKING

from msgspec import Struct

from allworlds.engines import TimeIsUp, check_deadline
from allworlds.judging import paper_bound
from allworlds.maps import CombinatorialMap, Dart
from allworlds.studies.optimum.knowledge import Places
from allworlds.studies.optimum.strategy import Strategy
from allworlds.studies.optimum.strategy_making import made_strategy

if TYPE_CHECKING:
    from allworlds.studies.optimum.place_tables import ToldApart


class BeforeSearch(Struct, frozen=True):
    """Facts about some worlds that a search need not find.

    Attributes:
        at_least: no explorer needs less in its worst world.
        enough: some explorer needs no more.
        told_apart: the largest number of places that can be told apart, if that is known.
    """

    at_least: int
    enough: int
    told_apart: ToldApart | None = None


class Solved(Struct, frozen=True):
    """Minimax over some worlds.

    Attributes:
        at_least: no explorer needs less in its worst world.
        at_most: the strategy needs no more; None where the time was up before there was one.
        strategy: the best one found.
        states: the number of states of knowledge that were examined.
    """

    at_least: int
    at_most: int | None
    strategy: Strategy | None
    states: int

    @property
    def closed(self) -> bool:
        """Whether both bounds are equal."""
        return self.at_least == self.at_most


def minimax(
    given: Iterable[tuple[CombinatorialMap, Dart, Dart]],
    deadline: float | None = None,
    before: BeforeSearch | None = None,
) -> Solved:
    """Find the fewest traversals that suffice in all these worlds, and a strategy for them.

    The explorer knows which worlds there are.

    Args:
        given: of each the map, the dart that the robot faces, and the dart of its vertex that
            the marker points at; at least one.
        deadline: of the search, on the monotonic clock; then what is known by then is told.
        before: what is known before; by default the bound of Algorithm 1.

    Cost: seconds for all worlds with 4 edges; it grows faster than any power.
    """
    from allworlds.studies.optimum.bracket import Bracket
    from allworlds.studies.optimum.place_tables import place_table

    places, tick = Places(), partial(check_deadline, deadline)
    every = [*given]
    if before is None:
        before = BeforeSearch(
            0, max(paper_bound(m.vertex_count, m.edge_count) for m, _, _ in every)
        )
    starts = places.parted([places.number(*world) for world in every])
    known = [part.known for part in starts if not places.settled(part.known)]
    if not known:
        made = made_strategy(places, starts, 0, lambda *_: None)
        return Solved(0, 0, made.strategy, 0)
    try:
        table = place_table(places, before.told_apart, tick)
    except TimeIsUp:
        return Solved(max(before.at_least, 1), None, None, 0)
    bracket = Bracket(table, known, max(before.at_least, 1), before.enough)
    with suppress(TimeIsUp):  # then both bounds are those found so far
        bracket.close(tick)
    if bracket.at_most is None:
        return Solved(bracket.at_least, None, None, bracket.states)
    made = made_strategy(places, starts, bracket.at_most, bracket.motion)
    return Solved(bracket.at_least, made.cost, made.strategy, bracket.states)
