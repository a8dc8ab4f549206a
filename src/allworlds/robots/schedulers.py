"""Schedulers: which robots are activated in the same step, and when a run is cut off."""

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
"""The schedulers with rounds; in each round the world makes a step, even if no robot acts."""


class ScheduledEvent(NamedTuple):
    """An event of a schedule that the user gives.

    Attributes:
        phases: a dictionary from each robot of the event to a letter: ``L`` (the robot looks, and
            moves later), ``M`` (it makes the move of an earlier look), or an empty text (it looks
            and moves at once).
        adversary: the index of the adversary's choice among the states that can follow.
    """

    phases: Mapping[int, str]
    adversary: int = 0

    @property
    def group(self) -> tuple[int, ...]:
        """The robots of the event, ascending."""
        return tuple(sorted(self.phases))


def schedule_of(text: str) -> tuple[ScheduledEvent, ...]:
    """The events of a schedule that is given as a text, such as ``0L 1L 0M 0+1:2``.

    Each word is an event.  In an event each robot is given by its number and a letter, with ``+``
    between two robots: ``L`` means that the robot looks, and moves later; ``M``, that it makes the
    move of an earlier look; no letter, that it looks and moves at once.  ``-`` stands for no robot.
    Behind a colon stands the index of the adversary's choice; without a colon it is 0.

    Raises:
        InputError: if a word of the text is no event; the error names the word.
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
        events.append(ScheduledEvent(phases, int(index or 0)))
    return tuple(events)


class Timing(Struct, frozen=True):
    """The schedules that are tried.

    Attributes:
        scheduler: the rule that says which robots are activated at once: ``fsync``, ``ssync``,
            ``central`` or ``async``.
        budget: the largest number of activations of a robot whose program is a generator.
        lead: the largest number of activations by which a robot may be ahead of another robot that
            can be activated; None for no limit.
        start_delay: the largest number of rounds by which robot 1 may begin later than the others.
        within: whether a run that exceeds the budget is a finding.
        configurations: the largest number of configurations of a search.
        schedule: the only schedule that is tried; None if every schedule is tried.
    """

    scheduler: Scheduler
    budget: int = 1000
    lead: int | None = None
    start_delay: int = 0
    within: bool = False
    configurations: int = 1_000_000
    schedule: tuple[ScheduledEvent, ...] | None = None

    @property
    def has_rounds(self) -> bool:
        """Whether the world makes a step in each round, even if no robot acts."""
        return self.scheduler in ROUNDS

    def groups(self, able: tuple[int, ...]) -> tuple[tuple[tuple[int, ...], int], ...]:
        """The sets of robots that can be activated at once, smallest first, each also as a bit set.

        ``able`` has the robots that can be activated.  Under ``async`` each robot of a set makes
        its next step: Look with Compute, or Move.
        """
        return _groups(self.scheduler, able)


def bits_of(robots: Iterable[int]) -> int:
    """A set of robots as a bit set: bit i stands for robot i."""
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
