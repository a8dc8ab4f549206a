"""The two kinds of players: an explorer behind its C interface, or a log that is read.

The judge calls both in one way; the kind is known when the judge is compiled.
"""

from __future__ import annotations

from typing import Any

from numba.extending import overload

from allworlds.engines.kernel.compiling import RECORD
from allworlds.engines.kernel.episode import meet
from allworlds.engines.kernel.logs import follow
from allworlds.engines.kernel.records import READER


def play(world: Any, explorer: Any, budget: int, beat: Any, log: Any, judged: Any) -> int:
    """The law that ended the episode, or 0 where there is an answer; ``log`` holds the walk.

    Args:
        world: of the robot.
        explorer: of one of these kinds.
        budget: the largest legal number of traversals; one checkpoint more is legal.
        beat: ``beat[1]`` grows at each turn of an explorer, as a heartbeat.
        log: is begun anew; the answer is written to it.
        judged: the verdict on the checkpoints, if ``log.watched``.
    """
    raise NotImplementedError


@overload(play, inline="always")
def _play(world, explorer, budget, beat, log, judged):
    def met(world, explorer, budget, beat, log, judged):
        return meet(world, explorer, budget, beat, log, judged)

    def read(world, explorer, budget, beat, log, judged):
        return follow(world, explorer, budget, log, judged)

    return read if explorer == RECORD(READER) else met
