"""Two robots that shall part: not if they begin on one dart, and are told the same.

Source: Augustine and Moses, Dispersion of Mobile Robots, ICDCN 2018, where robots have labels. That
two darts of one vertex are as good is ours.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from allworlds import Automaton, CombinatorialMap, Move
from allworlds.claims import Found, Means, truth
from allworlds.robots import search
from check import common_words
from small_automata import two_states
from worlds import EDGE, PATH_3, named, ring, simple_worlds


@dataclass(frozen=True)
class Dispersion(type(named("meeting"))):  # type: ignore[misc]  # the model of that name
    """Robots that shall be at different vertices."""

    def over(self, map_: CombinatorialMap, state: Any) -> bool:
        """Whether they are."""
        return len({map_.vertex_of[dart] for dart in state.darts}) == len(state.darts)


go = Automaton(None, lambda memory, _percept: (memory, Move(0)))
"""The robot that leaves by its own dart."""


def dispersion(_: Means, *, edges: int) -> Found:
    """On one dart they stay together whatever they do; else each goes by its own dart."""
    together = parted = wrong = searched = 0
    for map_ in simple_worlds(edges):
        pairs = common_words(map_.sigma, map_.alpha, 0, 0) or {(0, 1)}
        together += 1
        wrong += any(one != other for one, other in pairs)
        for dart in map_.vertices[map_.vertex_of[0]][1:]:
            parted += 1
            wrong += not search(map_, (0, dart), Dispersion(), [go] * 2, "fsync").holds
    for map_, degrees in ((EDGE, [1]), (ring(3), [2]), (PATH_3, [1, 2])):
        for program in two_states(degrees):
            searched += 1
            found = search(map_, (0, 0), Dispersion(), [program] * 2, "fsync")
            wrong += found.law != "progress"
    witnesses = {"worlds with both on one dart": together, "starts on two darts": parted}
    return Found(truth(not wrong), {**witnesses, "automata": searched})
