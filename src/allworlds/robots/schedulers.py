"""Schedulers: who is activated at once, and when a run is cut off."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from itertools import chain, combinations
from typing import NamedTuple

from msgspec import Struct

from allworlds.inputs.checks import InputError, show
from allworlds.robots.model import Scheduler

ROUNDS = "fsync", "ssync"
"""The schedulers with rounds, in each of which the world makes a step."""


class Scheduled(NamedTuple):
    """An event of a schedule that is given.

    Attributes:
        phases: of each robot that is activated the letter ``L`` (it looks, and moves later), ``M``
            (that move), or none.
        adversary: the index of what the adversary does.
    """

    phases: Mapping[int, str]
    adversary: int = 0

    @property
    def group(self) -> tuple[int, ...]:
        """The robots, ascending."""
        return tuple(sorted(self.phases))


def schedule_of(text: str) -> tuple[Scheduled, ...]:
    """The events of a text such as ``0L 1L 0M 0+1:2``; ``-`` stands for nobody.

    Raises:
        InputError: naming the word that is none.
    """
    events = []
    for word in text.split():
        who, _, index = word.partition(":")
        parts = [re.fullmatch("([0-9]{1,2})([LM]?)", part) for part in who.split("+")]
        known = who == "-" or all(parts)
        if not known or not re.fullmatch("[0-9]{0,6}", index):
            legal = "as in 0L 1L 0M 0+1:2: robots, L for a look, M for its move, and an index"
            raise InputError(f"schedule: {show(word)} is no event, {legal}")
        phases = {int(part[1]): part[2] for part in parts if part}
        events.append(Scheduled(phases, int(index or 0)))
    return tuple(events)


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
        schedule: the only one that is tried; None: every one.
    """

    scheduler: Scheduler
    budget: int = 1000
    lead: int | None = None
    start_delay: int = 0
    within: bool = False
    configurations: int = 1_000_000
    schedule: tuple[Scheduled, ...] | None = None

    @property
    def has_rounds(self) -> bool:
        """Whether the world makes a step in each round, though nobody acts."""
        return self.scheduler in ROUNDS

    def groups(self, able: tuple[int, ...]) -> tuple[tuple[tuple[int, ...], int], ...]:
        """The sets of robots that can be activated at once, the small ones first, each as bits too.

        Under ``async`` each of a set makes its next step: Look with Compute, or Move.
        """
        return _groups(self.scheduler, able)


def bits_of(robots: Iterable[int]) -> int:
    """A set of robots, as bits."""
    return sum(1 << robot for robot in robots)


@cache
def _groups(scheduler: Scheduler, able: tuple[int, ...]) -> tuple[tuple[tuple[int, ...], int], ...]:
    if scheduler == "fsync" or not able:
        sets: Iterable[tuple[int, ...]] = (able,)
    elif scheduler == "central":
        sets = ((robot,) for robot in able)
    else:
        sets = chain.from_iterable(combinations(able, size + 1) for size in range(len(able)))
    return tuple((each, bits_of(each)) for each in sets)
