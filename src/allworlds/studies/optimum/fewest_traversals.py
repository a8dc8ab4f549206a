"""Minimax over a robot's knowledge: the fewest traversals that suffice in every world.

Iterative deepening: whether t traversals are enough, for t = 0, 1, ... Bounds found for a state of
knowledge, from above and from below, are kept.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from allworlds.maps import CombinatorialMap
from allworlds.protocol import Estimate
from allworlds.studies.optimum.knowledge import Known, Places, SensedKnowledge
from allworlds.studies.optimum.strategy import Branch, Strategy, StrategyLeaf, StrategyStep


class Search:
    """Known values of states of knowledge, and the search for more.

    Attributes:
        places: the places that states are made of.
        states: how many were looked into, each as often as it was.

    Args:
        places: see above.
        tick: called for each state; it may raise, and the search can be asked again.
    """

    def __init__(self, places: Places, tick: Callable[[], None] = lambda: None) -> None:
        self.places = places
        self.states = 0
        self._tick = tick
        self._at_least: dict[Known, int] = {}
        self._enough: dict[Known, tuple[int, int]] = {}
        self._ways: dict[Known, list[tuple[int, list[SensedKnowledge]]]] = {}

    def value(self, known: Known) -> int:
        """The fewest traversals after which the robot knows map and place in every case."""
        most = self.at_least(known)
        while not self.within(known, most):
            most += 1
        return most

    def at_least(self, known: Known) -> int:
        """The largest lower bound found so far for the number of traversals."""
        found = self._at_least.get(known)
        if found is None:
            found = self._at_least[known] = int(not self.places.settled(known))
        return found

    def within(self, known: Known, most: int) -> bool:
        """Whether ``most`` traversals are enough."""
        least = self.at_least(known)
        if least == 0 or least > most:
            return least == 0
        if known in self._enough and self._enough[known][0] <= most:
            return True
        self.states += 1
        self._tick()
        for k, parts in self._ways_from(known):
            if all(self.at_least(part.known) < most for part in parts) and all(
                self.within(part.known, most - 1) for part in parts
            ):
                # Further down the same state may have been met, with less left.
                self._enough[known] = min(self._enough.get(known, (most, k)), (most, k))
                return True
        self._at_least[known] = most + 1
        return False

    def _ways_from(self, known: Known) -> list[tuple[int, list[SensedKnowledge]]]:
        """The motions, each with the possible states of knowledge after it.

        The states of a motion are ordered from most possible answers to fewest; the motions by the
        number of answers left in their first state, fewest first.
        """
        ways = self._ways.get(known)
        if ways is None:
            answers = self.places.answers
            ways = []
            for k in range(self.places.degree(known)):
                parts = self.places.moved(known, k)
                parts.sort(key=lambda part: -answers(part.known))
                ways.append((k, parts))
            ways.sort(key=lambda way: answers(way[1][0].known))
            self._ways[known] = ways
        return ways

    def strategy(self, starts: Sequence[SensedKnowledge]) -> Strategy:
        """A strategy from these states on, whose values have been found."""
        nodes: list[StrategyStep | StrategyLeaf] = []
        numbers: dict[tuple[Known, int], int] = {}

        def branches(parts: Sequence[SensedKnowledge]) -> tuple[Branch, ...]:
            return tuple(Branch(percept=part.percept, node=node_of(part)) for part in parts)

        def node_of(part: SensedKnowledge) -> int:
            key = part.known, part.turned
            if key not in numbers:
                nodes.append(self._node(part, branches))
                numbers[key] = len(nodes) - 1
            return numbers[key]

        return Strategy(start=branches(starts), nodes=tuple(nodes))

    def _node(
        self,
        part: SensedKnowledge,
        branches: Callable[[Sequence[SensedKnowledge]], tuple[Branch, ...]],
    ) -> StrategyStep | StrategyLeaf:
        """A node seen from the dart that the robot has come by, not the one it has turned to."""
        known, turned, places = part.known, part.turned, self.places
        if places.settled(known):
            map_ = CombinatorialMap.trusted(*places.places[known[0]].code)
            return StrategyLeaf(answer=Estimate(map_, map_.turn(0, -turned)))
        _, k = self._enough[known]
        then = branches(places.moved(known, k))
        return StrategyStep(move=(k + turned) % places.degree(known), then=then)
