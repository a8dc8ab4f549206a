"""The runs of an explorer in every world to a bound, for ``certified_trees.py``.

A user's explorer runs in a process of its own, as in ``allworlds check``: it can harm that process
alone, and its silence is ended after the time that was given.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import closing
from itertools import islice

from allworlds.engines.judge import Due, PythonJudge
from allworlds.engines.lane import answered, started
from allworlds.engines.limits import Limits
from allworlds.engines.players import Lost, Setup
from allworlds.engines.tally import RunCounter
from allworlds.engines.units import Scope
from allworlds.explorers.loading import Subject
from allworlds.judging.episode import Episode, Fault
from allworlds.judging.findings.rules import Rules
from allworlds.log import Log
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.world import World

AT_A_TIME = 256
"""The number of runs that a process is given at a time."""


class NoAnswer(Exception):
    """Raised where a run is silent, or has cost its process; the message says which law it breaks.

    Each further run might take as long.
    """


def episodes(
    subject: Subject, worlds: Iterable[World], budget: int, limits: Limits
) -> Iterator[Episode]:
    """Yield the run in each world, with the same budget of steps in all of them.

    Raises:
        NoAnswer: at the first run that is silent, or has cost its process.
    """
    every = iter(worlds)
    with closing(started(Setup(subject, limits), seed=0)) as player:
        while some := list(islice(every, AT_A_TIME)):
            extent = Extent(MapClass.MAPS, max(world.map.edge_count for world in some))
            counter = RunCounter(Scope(extent, Rules(step_budget=budget)), keep=1)
            judge = PythonJudge(counter, subject.name)
            message = judge.worlds_message([Due(0, 0, world) for world in some])
            try:
                logs = answered(player, message)
            except Lost as lost:
                raise NoAnswer(f"{lost.law}: {lost.seen}") from None
            for world, log in zip(some, logs, strict=True):
                episode = judge.episode(world, Log(log))
                if isinstance(episode.ending, Fault) and episode.ending.law == "timeout":
                    raise NoAnswer(f"timeout: {episode.ending.seen}")
                yield episode
