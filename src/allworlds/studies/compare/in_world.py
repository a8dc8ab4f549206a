"""Costs of one explorer in one world, as rows for programs have them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from allworlds.maps import CombinatorialMap


class InWorld(NamedTuple):
    """An explorer's runs in one world.

    Attributes:
        map: rooted at dart 0.
        member: the words that name the world in a family; empty where there is no family.
        explorer: its name.
        costs: traversals by the number of the lighthouse's place.
        places: the number of all places.
        bound: on the traversals of a run, the same in each place; None without one.
        drawn_from: the number of different worlds of this size that seeds draw, where it is known.
        finished: all worlds of this size were run.
    """

    map: CombinatorialMap
    member: str
    explorer: str
    costs: Mapping[int, int]
    places: int
    bound: int | None
    drawn_from: int | None = None
    finished: bool = True

    @property
    def mean(self) -> float:
        """The mean cost of the runs."""
        return sum(self.costs.values()) / len(self.costs)
