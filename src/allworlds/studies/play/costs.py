"""Costs beside the player's, in the world that is played."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Annotated

from allworlds.document import Document, Natural, about
from allworlds.engines import Limits, single_run, subject_of
from allworlds.explorers import BUILT_IN
from allworlds.judging import AskedRules
from allworlds.maps import covering_walk
from allworlds.world import World, kind_of

LARGEST = 200
"""The most edges for which Algorithm 1 takes no more than some seconds."""

VARIANTS = {
    BUILT_IN[name].lighthouse: name
    for name in ("algorithm1", "algorithm1-cluster", "algorithm1-natural")
}
"""Algorithm 1 for each lighthouse that it is written for."""


class Walker(StrEnum):
    """Whose cost it is."""

    ALGORITHM_1 = "algorithm1"
    EVERY_EDGE = "every-edge"


class CostBeside(Document):
    """The cost of somebody else in the world that is played."""

    who: Annotated[
        Walker,
        about(
            "`algorithm1`; `every-edge`: the shortest walk from the start along every edge, for "
            "which one must know the map"
        ),
    ]
    cost: Annotated[Natural, about("traversals")]


def costs_beside(world: World) -> tuple[CostBeside, ...]:
    """The costs of Algorithm 1, where it is known, and of the shortest walk along every edge.

    Cost: seconds at most; larger worlds do not have the first.
    """
    return tuple(CostBeside(who=who, cost=cost) for who, cost in _costs(world))


def _costs(world: World) -> Iterator[tuple[Walker, int]]:
    edges, kind = world.map.edge_count, world.lighthouse.kind
    if edges <= LARGEST and kind in VARIANTS:
        subject = subject_of(VARIANTS[kind], Limits())
        rules = AskedRules().rules_of(subject, kind_of(world.lighthouse))
        yield Walker.ALGORITHM_1, single_run(subject, world, rules, (), Limits()).cost
    yield Walker.EVERY_EDGE, covering_walk(world.map, world.start)


def not_compared(world: World) -> str:
    """A sentence that says that Algorithm 1 is not compared, and why; empty where it is."""
    edges, kind = world.map.edge_count, world.lighthouse.kind
    if kind not in VARIANTS:
        return f"Algorithm 1 is not for the {kind} lighthouse."
    if edges > LARGEST:
        return f"Algorithm 1 is not run in worlds with more than {LARGEST} edges."
    return ""
