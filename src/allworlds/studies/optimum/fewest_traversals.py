"""Minimax over a robot's knowledge: the readable twin of the compiled search.

Iterative deepening: whether t traversals are enough, for t = 0, 1, ... Bounds found for a state of
knowledge, from above and from below, are kept.  Tests compare it with the search of
:mod:`allworlds.engines.kernel.minimax`, which gives states up earlier.
"""

from __future__ import annotations

from allworlds.studies.optimum.knowledge import Known, Places, SensedKnowledge


class Search:
    """Known values of states of knowledge, and the search for more.

    Attributes:
        places: the places that states are made of.
        states: how many were looked into, each as often as it was.

    Args:
        places: see above.
    """

    def __init__(self, places: Places) -> None:
        self.places = places
        self.states = 0
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

    def motion(self, known: Known, most: int) -> tuple[int, int] | None:
        """A number of traversals that is enough, at most ``most``, and a first motion; or None."""
        return self._enough[known] if self.within(known, most) else None
