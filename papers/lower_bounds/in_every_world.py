"""A check of the strategy that the search has found: it is followed in every world.

It shares nothing with the search but the strategy: it walks in worlds, and compares codes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from allworlds import CombinatorialMap, Estimate, Move, Percept, World
from allworlds.maps import rooted_code
from minimax import Branch, Strategy, StrategyLeaf


def most_expensive(strategy: Strategy, worlds: Iterable[World]) -> int | None:
    """The most traversals that the strategy makes in any of the worlds.

    None if it is wrong in one: it answers with another rooted map, or has nothing to go on with.
    Cost: linear in the traversals.
    """
    most = 0
    for world in worlds:
        cost = _followed(strategy, world)
        if cost is None:
            return None
        most = max(most, cost)
    return most


def _followed(strategy: Strategy, world: World) -> int | None:
    """The traversals to the right answer in a world; None where it is not reached."""
    state, number, cost = world.initial, _node_after(world.first, strategy.start), 0
    while number is not None:
        node = strategy.nodes[number]
        if isinstance(node, StrategyLeaf):
            return cost if _is_right(node.answer, world.map, state.dart) else None
        if cost > len(strategy.nodes):
            return None
        state, percept = world.step(state, Move(node.move))
        cost += 1
        number = _node_after(percept, node.then)
    return None


def _node_after(percept: Percept, branches: Sequence[Branch]) -> int | None:
    """The number of the node to go on with; None where there is none."""
    return next((branch.node for branch in branches if branch.percept == percept), None)


def _is_right(answer: Estimate, map_: CombinatorialMap, dart: int) -> bool:
    found = answer.map
    return rooted_code(found.sigma, found.alpha, answer.here) == rooted_code(
        map_.sigma, map_.alpha, dart
    )
