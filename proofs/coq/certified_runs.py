"""The runs of an explorer, in every world to a bound or along given percepts.

A user's explorer runs in a process of its own, as in ``allworlds check``: it can harm that process
alone, and its silence is ended after the time that was given.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing
from itertools import islice
from typing import Any

from allworlds.engines.batch import Due, Recorded
from allworlds.engines.judge import PythonJudge
from allworlds.engines.limits import Limits
from allworlds.engines.players import Lost, PlayerHere, PlayerProcess, Setup, answered, started
from allworlds.engines.tally import RunCounter
from allworlds.engines.units import Scope
from allworlds.explorers.loading import Subject
from allworlds.judging.episode import Episode, EpisodeEnding, Fault, fault_of
from allworlds.judging.rules import Rules
from allworlds.log import Log
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.protocol.actions import Percept
from allworlds.world import World, worlds

AT_A_TIME = 256
"""The number of runs that a process is given at a time."""


class NoAnswer(Exception):
    """Raised where a run is silent, or has cost its process; the message says which law it breaks.

    Each further run might take as long.
    """


def episodes(
    subject: Subject, every: Iterable[World], budget: int, limits: Limits
) -> Iterator[Episode]:
    """Yield the run in each world, with the same budget of steps in all of them.

    Raises:
        NoAnswer: at the first run that is silent, or has cost its process.
    """
    left = iter(every)
    with closing(started(Setup(subject, limits), seed=0)) as player:
        while some := list(islice(left, AT_A_TIME)):
            judge = _judge(subject, max(world.map.edge_count for world in some), budget)
            message = judge.worlds_message([Due(0, 0, world) for world in some])
            for world, log in zip(some, _logs(player, message), strict=True):
                episode = judge.episode(world, Log(log))
                _seen(episode.ending)
                yield episode


def logs_along(
    subject: Subject, every: Iterable[list[Percept]], edges: int, budget: int, limits: Limits
) -> Iterator[Log]:
    """Yield the log of the run in which an explorer senses these percepts, for each list of them.

    Raises:
        NoAnswer: at the first run that is silent, or has cost its process.
    """
    # of the world that is not there only the size counts, and that of none as a budget is given
    judge, nowhere = _judge(subject, edges, budget), next(iter(worlds(edges=1)))
    left = iter(every)
    with closing(started(Setup(subject, limits), seed=0)) as player:
        while some := list(islice(left, AT_A_TIME)):
            message = judge.percepts_message([Recorded(percepts, nowhere) for percepts in some])
            for log in map(Log, _logs(player, message)):
                _seen(fault_of(log, budget))
                yield log


def _judge(subject: Subject, edges: int, budget: int) -> PythonJudge:
    scope = Scope(Extent(MapClass.MAPS, edges), Rules(step_budget=budget))
    return PythonJudge(RunCounter(scope, keep=1), subject.name)


def _logs(player: PlayerProcess | PlayerHere, message: dict[str, Any]) -> Sequence[bytes]:
    try:
        return answered(player, message)
    except Lost as lost:
        raise NoAnswer(f"{lost.law}: {lost.seen}") from None


def _seen(ending: EpisodeEnding | None) -> None:
    """Let the whole end at the first run that is silent."""
    if isinstance(ending, Fault) and ending.law == "timeout":
        raise NoAnswer(f"timeout: {ending.seen}")
