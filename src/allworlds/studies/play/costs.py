"""Costs beside the player's, in the world that is played."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from functools import cache
from typing import Annotated

from allworlds.document import Document, Natural, about
from allworlds.engines import COMPILER, Limits, single_run, subject_of
from allworlds.explorers import BUILT_IN
from allworlds.inputs import lack_of
from allworlds.judging import AskedRules
from allworlds.maps import covering_walk, rooted_maps
from allworlds.studies.optimum import Strategy, minimax, most_expensive
from allworlds.words import plural
from allworlds.world import Directional, World, kind_of

LARGEST = 200
"""The most edges for which Algorithm 1 takes no more than some seconds."""

EASY_EDGES, EASY_DEGREE = 4, 4
"""The optimum takes seconds at most: with so many edges, or with one more and such a start."""

VARIANTS = {
    BUILT_IN[name].lighthouse: name
    for name in ("algorithm1", "algorithm1-cluster", "algorithm1-natural")
}
"""Algorithm 1 for each lighthouse that it is written for."""


class Walker(StrEnum):
    """Whose cost it is."""

    ALGORITHM_1 = "algorithm1"
    OPTIMUM = "optimum"
    EVERY_EDGE = "every-edge"


class CostBeside(Document):
    """The cost of somebody else in the world that is played."""

    who: Annotated[
        Walker,
        about(
            "`algorithm1`; `optimum`: a strategy that knows the number of edges and has the best "
            "worst case among the worlds with this first percept; `every-edge`: the shortest walk "
            "from the start along every edge, for which one must know the map"
        ),
    ]
    cost: Annotated[Natural, about("traversals")]


def costs_beside(world: World) -> tuple[CostBeside, ...]:
    """The costs of Algorithm 1 and of the optimum, where they are known, and of every edge.

    Cost: seconds at most; larger worlds have neither of the first two.
    """
    return tuple(CostBeside(who=who, cost=cost) for who, cost in _costs(world))


def _costs(world: World) -> Iterator[tuple[Walker, int]]:
    edges, kind = world.map.edge_count, world.lighthouse.kind
    if edges <= LARGEST and kind in VARIANTS:
        subject = subject_of(VARIANTS[kind], Limits())
        rules = AskedRules().rules_of(subject, kind_of(world.lighthouse))
        yield Walker.ALGORITHM_1, single_run(subject, world, rules, (), Limits()).cost
    easy = is_easy(edges, world.first.degree) and not lack_of(*COMPILER)
    if isinstance(world.lighthouse, Directional) and easy:
        bearing = world.first.bearing
        assert bearing is not None
        cost = most_expensive(_optimum(edges, world.first.degree, bearing), [world])
        assert cost is not None
        yield Walker.OPTIMUM, cost
    yield Walker.EVERY_EDGE, covering_walk(world.map, world.start)


def is_easy(edges: int, degree: int) -> bool:
    """Whether the optimum is found in seconds: a start of high degree tells much."""
    return edges <= EASY_EDGES or (edges == EASY_EDGES + 1 and degree >= EASY_DEGREE)


@cache
def _optimum(edges: int, degree: int, bearing: int) -> Strategy:
    """The best strategy for all worlds with that many edges and that first percept."""
    every = [
        (map_, 0, map_.turn(0, bearing))
        for map_ in rooted_maps(edges)
        if map_.degree_at[0] == degree
    ]
    strategy = minimax(every).strategy
    assert strategy is not None
    return strategy


def not_compared(world: World) -> str:
    """A sentence that says who is not compared, and why; empty where everybody is."""
    edges, kind = world.map.edge_count, world.lighthouse.kind
    if kind not in VARIANTS:
        return f"Algorithm 1 and the optimum are not for the {kind} lighthouse."
    if edges > LARGEST:
        return f"Algorithm 1 is not run in worlds with more than {LARGEST} edges."
    if kind != Directional.kind:
        return f"The optimum is not known under the {kind} lighthouse."
    if not is_easy(edges, world.first.degree):
        return f"The optimum is not known for {plural(edges, 'edge')} and this start."
    if lack := lack_of(*COMPILER):
        return f"The optimum {lack}."
    return ""
