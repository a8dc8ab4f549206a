"""Schedulers: who is activated at once, and when a run is cut off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, combinations

from msgspec import Struct

from allworlds.robots.model import Scheduler

ROUNDS = "fsync", "ssync"
"""The schedulers with rounds, in each of which the world makes a step."""


class Time(Struct, frozen=True):
    """The schedules that are tried.

    Attributes:
        scheduler: see :data:`allworlds.robots.model.Scheduler`.
        budget: no robot whose program is a generator is activated more often.
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

    def groups(self, able: Sequence[int]) -> Iterator[tuple[int, ...]]:
        """The sets of robots that can be activated at once, the small ones first.

        Under ``async`` each of a set makes its next step: Look with Compute, or Move.
        """
        if self.scheduler == "fsync":
            yield tuple(able)
        elif self.scheduler == "central":
            yield from ((robot,) for robot in able)
        else:
            sizes = range(1, len(able) + 1)
            yield from chain.from_iterable(combinations(able, size) for size in sizes)
