"""The runs of an explorer in every world to a bound, for ``certified_trees.py``.

A user's explorer runs in a process of its own, as in ``allworlds check``: it can harm that process
alone, and its silence is ended after the time that was given.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import closing
from itertools import islice
from random import Random

from allworlds.engines.isolation.jobs import PlayerSetup
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.process import guardian

from allworlds.engines import GivenWorlds, Limits, Scope
from allworlds.engines.python.run_counter import RunCounter
from allworlds.explorers import Subject
from allworlds.judging import Episode, Fault, LostRun, Rules, place_of, play, retold
from allworlds.maps import Extent, MapClass
from allworlds.protocol import Choices
from allworlds.world import World

AT_A_TIME = 256
"""The number of runs that a process is given at a time."""


class NoAnswer(Exception):
    """Raised where a run is silent, or has cost its process; the message says which law it breaks.

    Each further run might take as long.
    """

    def __init__(self, fault: Fault) -> None:
        super().__init__(f"{fault.law}: {fault.seen}")


def episodes(
    subject: Subject, worlds: Iterable[World], budget: int, limits: Limits
) -> Iterator[Episode]:
    """Yield the run in each world, in any order, with the same budget of steps in all of them.

    Raises:
        NoAnswer: at the first run that is silent, or has cost its process.
    """
    player = None if subject.importable else subject.player()
    if player is None:
        runs = _apart(subject, worlds, budget, limits)
    else:
        runs = (play(world, player, Choices(), budget) for world in worlds)
    for episode in runs:
        if isinstance(episode.ending, Fault) and episode.ending.law == "timeout":
            raise NoAnswer(episode.ending)
        yield episode


def _apart(
    subject: Subject, worlds: Iterable[World], budget: int, limits: Limits
) -> Iterator[Episode]:
    every = iter(worlds)
    # the order is the same each time, so that the same is said of an explorer each time
    with closing(PlayerPair(guardian(), PlayerSetup.of(subject, limits), Random(0))) as players:
        while some := tuple((world, place_of(world)) for world in islice(every, AT_A_TIME)):
            extent = Extent(MapClass.MAPS, max(world.map.edge_count for world, _ in some))
            runs = RunCounter(Scope(extent, Rules(step_budget=budget)), keep=1)
            for logs in players.play_runs(runs, GivenWorlds(some), range(len(some))):
                for number, log in logs:
                    if isinstance(log.ending, LostRun):
                        raise NoAnswer(log.ending)
                    yield retold(log, some[number][0])
