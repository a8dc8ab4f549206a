"""Stretches played by explorers that are generators: a function in Python, a program behind a pipe.

What a run did is left behind as the bytes that the kernel reads (:mod:`allworlds.kernel.logs`), so
that explorers of every kind are judged by the same compiled judge.
"""

from __future__ import annotations

from collections.abc import Callable, MutableSequence
from functools import lru_cache
from random import Random

from allworlds.episode import Log, Player, Said, Stage, perform
from allworlds.isolation.jobs import PlayStretch, Stretched
from allworlds.isolation.stretches import Shown
from allworlds.protocol import Action, Choices, Move, Percept, policy_named
from allworlds.world import IllegalAction

class Scribe:
    """A player's side of stretches, for a generator that is here.

    Args:
        player: the explorer.
        beat: ``beat[0]`` is set to the number of each run; see :func:`allworlds.episode.play`.
        intact: called after each play, to look at what the explorer may have broken.
    """

    def __init__(
        self, player: Player, beat: MutableSequence[int], intact: Callable[[], None]
    ) -> None:
        self._player, self._beat, self._intact = player, beat, intact
        self._shown = Shown()

    def play(self, job: PlayStretch) -> Stretched:
        """All runs of a stretch; its logs come to stand in the memory, if there is room."""
        stretch = self._shown.stretch(job)
        heads = stretch.heads[: job.runs].tolist()
        logs, begins = bytearray(), [0] * job.runs
        order = [*range(job.runs)]
        Random(job.order).shuffle(order)  # noqa: S311  # it need not be secret for longer than a run
        for run in order:
            budget, told, number, motions = heads[run]
            self._beat[0] = number
            stage: Stage
            if job.again:
                start = int(stretch.starts[run])
                sensed = stretch.percepts[start : start + 3 * (motions + 1)].tobytes()
                stage = Recorded(sensed, told)
            else:
                stage = Tabled(stretch.worlds[run].tobytes(), told)
            choices = Choices(policy_named(job.policy))
            log = perform(stage, self._player, choices, budget, self._beat)
            begins[run] = len(logs)
            logs += text_of(log._replace(checkpoints=()) if job.again else log)
            self._intact()
        return Stretched(stretch.put(logs, begins), 0)


class Tabled:
    """A world without markers, as the kernel lays it out: five bytes for each dart.

    The state is the robot's dart.
    """

    def __init__(self, table: bytes, told: int) -> None:
        self.initial, self.told = 0, _heard(told)
        self.first = _sensed(*table[2:5])
        self._table = table

    def step(self, state: int, action: Action) -> tuple[int, Percept]:
        """The dart arrived by, and what is sensed there.

        Raises:
            IllegalAction: for markers; there are none.
        """
        if type(action) is not Move:
            raise IllegalAction("nothing but motions: there are no markers")
        table = self._table
        first, _, degree, *_ = table[5 * state : 5 * state + 5]
        leaving = first + (state - first + action.k) % degree
        arrived = table[5 * leaving + 1]
        at = 5 * arrived
        return arrived, _sensed(table[at + 2], table[at + 3], table[at + 4])


class Recorded:
    """In place of a world: what was sensed in the first play, three bytes each.

    The state is where the last percept begins.
    """

    def __init__(self, sensed: bytes, told: int) -> None:
        self.initial, self.told = 0, _heard(told)
        self.first = _sensed(*sensed[:3])
        self._sensed = sensed

    def step(self, state: int, _action: Action) -> tuple[int, Percept]:
        """The next percept.

        Raises:
            IllegalAction: past the end of the record.
        """
        at = state + 3
        if at == len(self._sensed):
            raise IllegalAction("nothing: the record ends here")
        return at, _sensed(*self._sensed[at : at + 3])


@lru_cache(maxsize=1 << 12)
def _sensed(degree: int, marks: int, bearing: int) -> Percept:
    """What stands in three bytes."""
    return Percept(degree, marks, bearing - 1 if bearing else None)


def _heard(told: int) -> int | None:
    return None if told < 0 else told


def text_of(log: Log) -> bytes:
    """The log in bytes; what did not end in an answer is strange."""
    from allworlds.kernel import STRANGE_LOG, written_log

    ending = log.ending
    if type(ending) is not Said:
        return STRANGE_LOG
    shown = [(steps, (sigma, alpha, here)) for steps, sigma, alpha, here in log.checkpoints]
    return written_log(log.actions, shown, (ending.sigma, ending.alpha, ending.here))
