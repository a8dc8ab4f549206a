"""A strategy made of the motions that a search has found."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

from allworlds.maps import CombinatorialMap
from allworlds.protocol import Estimate
from allworlds.studies.optimum.knowledge import Known, Places, SensedKnowledge
from allworlds.studies.optimum.strategy import Branch, Strategy, StrategyLeaf, StrategyStep

FoundMotion: TypeAlias = Callable[[Known, int], tuple[int, int] | None]
"""For a state and a number of traversals that is enough: one that is not larger and is enough, too,
and a first motion."""


class MadeStrategy(NamedTuple):
    """A strategy.

    Attributes:
        strategy: its nodes.
        cost: the most traversals on a way through it.
    """

    strategy: Strategy
    cost: int


def made_strategy(
    places: Places, starts: Sequence[SensedKnowledge], most: int, motion: FoundMotion
) -> MadeStrategy:
    """The strategy from these states on, for each of which ``most`` traversals are enough."""
    maker = _Maker(places, motion)
    start = maker.branches(starts, most)
    cost = max(maker.costs[branch.node] for branch in start)
    return MadeStrategy(Strategy(start=start, nodes=tuple(maker.nodes)), cost)


class _Maker:
    """The nodes made so far, and the most traversals from each."""

    def __init__(self, places: Places, motion: FoundMotion) -> None:
        self.nodes: list[StrategyStep | StrategyLeaf] = []
        self.costs: list[int] = []
        self._places, self._motion = places, motion
        self._numbers: dict[tuple[Known, int, int], int] = {}

    def branches(self, parts: Sequence[SensedKnowledge], most: int) -> tuple[Branch, ...]:
        """The next nodes, by the percept."""
        return tuple(Branch(percept=part.percept, node=self._number(part, most)) for part in parts)

    def _number(self, part: SensedKnowledge, most: int) -> int:
        """The number of the node for a state, made if it is new."""
        known, turned, places = part.known, part.turned, self._places
        enough, k = 0, 0
        if not places.settled(known):
            found = self._motion(known, most)
            assert found is not None, "the search has found a motion here"
            enough, k = found
        key = known, turned, enough
        if key not in self._numbers:
            node: StrategyStep | StrategyLeaf
            cost = 0
            if enough:
                then = self.branches(places.moved(known, k), enough - 1)
                # Seen from the dart that the robot has come by, not the one it has turned to.
                node = StrategyStep(move=(k + turned) % places.degree(known), then=then)
                cost = 1 + max(self.costs[branch.node] for branch in then)
            else:
                map_ = CombinatorialMap.trusted(*places.places[known[0]].code)
                node = StrategyLeaf(answer=Estimate(map_, map_.turn(0, -turned)))
            self._numbers[key] = len(self.nodes)
            self.nodes.append(node)
            self.costs.append(cost)
        return self._numbers[key]
