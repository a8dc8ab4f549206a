"""Schedulers: who is activated at once, and when a run is cut off."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from itertools import chain, combinations

from msgspec import Struct

from allworlds.robots.model import Scheduler

ROUNDS = "fsync", "ssync"
"""The schedulers with rounds, in each of which the world makes a step."""


class Time(Struct, frozen=True):
    """The schedules that are tried.

    Attributes:
        scheduler: see :data:`allworlds.robots.model.Scheduler`.
        budget: no robot whose program is a generator is activated more often; nor any other one in
            a team with such a robot.
        lead: nobody is more than so many activations ahead of one that could be activated; None:
            without a limit.
        start_delay: robot 1 begins up to so many rounds later.
        within: whether the budget is a bound that must be kept.
        configurations: the largest number of a search.
    """

    scheduler: Scheduler
    budget: int = 1000
    lead: int | None = None
    start_delay: int = 0
    within: bool = False
    configurations: int = 1_000_000

    @property
    def has_rounds(self) -> bool:
        """Whether the world makes a step in each round, though nobody acts."""
        return self.scheduler in ROUNDS

    def groups(self, able: tuple[int, ...]) -> tuple[tuple[tuple[int, ...], int], ...]:
        """The sets of robots that can be activated at once, the small ones first, each as bits too.

        Under ``async`` each of a set makes its next step: Look with Compute, or Move.
        """
        return _groups(self.scheduler, able)


@cache
def _groups(scheduler: Scheduler, able: tuple[int, ...]) -> tuple[tuple[tuple[int, ...], int], ...]:
    if scheduler == "fsync" or not able:
        sets: Iterable[tuple[int, ...]] = (able,)
    elif scheduler == "central":
        sets = ((robot,) for robot in able)
    else:
        sets = chain.from_iterable(combinations(able, size + 1) for size in range(len(able)))
    return tuple((each, sum(1 << robot for robot in each)) for each in sets)
