"""Costs beside that of the player, in the world that is played."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from allworlds.maps import rooted_maps
from allworlds.studies.optimum import Strategy, minimax, most_expensive
from allworlds.studies.run import run
from allworlds.world import Directional, World

LARGEST, LARGEST_OPTIMUM = 200, 3
"""The most edges for which Algorithm 1, and the optimum, take no more than some seconds."""


class CostBeside(NamedTuple):
    """The cost of somebody else in the same world."""

    who: str
    cost: int


def costs_beside(world: World) -> list[CostBeside]:
    """The costs of Algorithm 1, of the optimum as far as it is known, and the least possible one.

    The optimum is a strategy for who knows the number of edges, best in its worst world; here it
    may need less.  Who does not know that number walks each edge.  Empty under another lighthouse
    than the directional one.

    Cost: seconds at most; in larger worlds Algorithm 1 is left out.
    """
    if not isinstance(world.lighthouse, Directional):
        return []
    edges, made = world.map.edge_count, list[CostBeside]()
    if edges <= LARGEST:
        made.append(CostBeside("Algorithm 1", run("algorithm1", world).cost))
    if edges <= LARGEST_OPTIMUM:
        cost = most_expensive(_optimum(edges), [world])
        assert cost is not None
        made.append(CostBeside("the optimum, which knows the number of edges", cost))
    made.append(CostBeside("each edge once, which is the least without that number", edges))
    return made


@cache
def _optimum(edges: int) -> Strategy:
    """The best strategy for all worlds with that many edges."""
    every = [
        (map_, 0, place.dart)
        for map_ in rooted_maps(edges)
        for place in Directional.places(map_, 0)
    ]
    strategy = minimax(every).strategy
    assert strategy is not None
    return strategy


def in_words(beside: list[CostBeside]) -> str:
    """A sentence; empty if there is nothing to compare with."""
    told = "; ".join(f"{one.who}: {one.cost}" for one in beside)
    return f"In this world {told}." if told else ""
