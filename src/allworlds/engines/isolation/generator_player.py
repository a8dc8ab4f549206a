"""Stretches played by explorers that are generators: a function in Python, a program behind a pipe.

The log of a run is written in the bytes that the kernel reads
(:mod:`allworlds.engines.kernel.logs`), so that one compiled judge judges explorers of every kind.
The twin of :func:`log_of_run` is :func:`allworlds.judging.episode.perform`, which also describes
faults; the general engine calls it for a run with a fault.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, MutableSequence
from random import Random
from typing import Any

from allworlds.engines.isolation.jobs import PlayStretch
from allworlds.engines.isolation.log_entries import (
    entry_of_answer,
    entry_of_checkpoint,
    motion_of,
)
from allworlds.engines.isolation.messages import StretchResult
from allworlds.engines.isolation.shared_logs import OpenedMemories
from allworlds.engines.kernel.stretch import (
    HEAD,
    RUN_BUDGET,
    RUN_MOTIONS,
    RUN_NUMBER,
    RUN_TOLD,
    Stretch,
)
from allworlds.engines.kernel.writing import LogEnd
from allworlds.engines.python.play import Recorded
from allworlds.inputs import let_users_interrupt
from allworlds.judging import closed
from allworlds.protocol import (
    Checkpoint,
    Choices,
    ExplorerFault,
    Move,
    Percept,
    Player,
    policy_named,
)
from allworlds.world import IllegalAction


class GeneratorPlayer:
    """A player's side of stretches, for a generator that is here.

    Args:
        player: the explorer.
        beat: ``beat[0]`` is set to the number of each run; see
            :func:`allworlds.judging.episode.play`.
        intact: called after each play, to check the parts that the explorer may have broken.
    """

    def __init__(
        self, player: Player, beat: MutableSequence[int], intact: Callable[[], None]
    ) -> None:
        self._player, self._beat, self._intact = player, beat, intact
        self._memories = OpenedMemories()

    def play(self, job: PlayStretch) -> StretchResult:
        """Play all runs of a stretch, and put their logs into the memory.

        No log is put there if there is no room, or if the machine may be the cause of a fault.
        """
        stretch = self._memories.stretch(job)
        logs, begins = bytearray(), [0] * job.runs
        order = [*range(job.runs)]
        Random(job.order).shuffle(order)  # noqa: S311  # it need not be secret for longer than a run
        for run in order:
            begins[run] = len(logs)
            log = self._log(stretch, run, job)
            if log is None:
                return StretchResult(-1, 0)
            logs += log
        return StretchResult(stretch.put(logs, begins), 0)

    def _log(self, stretch: Stretch, run: int, job: PlayStretch) -> bytes | None:
        """The log of one run; None if the machine may have made it go wrong."""
        row = stretch.heads[HEAD * run : HEAD * (run + 1)].tolist()
        budget, told = row[RUN_BUDGET], row[RUN_TOLD]
        self._beat[0] = row[RUN_NUMBER]
        world: ByteWorld | Recorded
        if job.again:
            start = stretch.starts[run]
            end = start + 3 * (row[RUN_MOTIONS] + 1)
            world = recorded(stretch.percepts[start:end].tobytes(), told)
        else:
            table = stretch.worlds[stretch.wide * run : stretch.wide * (run + 1)]
            world = ByteWorld(table.tobytes(), told)
        choices = Choices(policy_named(job.policy))
        log = log_of_run(world, self._player, choices, budget, self._beat)
        self._intact()
        return log


def load() -> None:
    """Load this module, and with it all modules that players need to write logs."""


class ByteWorld:
    """A world as the kernel lays it out: five bytes for each dart.

    The first two are the first dart of its vertex and the dart behind its edge; the others are the
    percept there.  The state is the robot's dart.

    Attributes:
        initial, first, told: as those of a world.
    """

    def __init__(self, table: bytes, told: int) -> None:
        self._table = table
        self.initial, self.first, self.told = 0, _percept(*table[2:5]), _told(told)

    def step(self, state: int, motion: int) -> tuple[int, Percept]:
        """The dart behind a motion, which is below the degree, and the percept there."""
        table, leaving = self._table, state + motion
        first, _, degree = table[5 * state : 5 * state + 3]
        if leaving >= first + degree:
            leaving -= degree
        arrived = table[5 * leaving + 1]
        return arrived, _percept(*table[5 * arrived + 2 : 5 * arrived + 5])


def recorded(sensed: bytes, told: int) -> Recorded:
    """The percepts of a first play, three bytes each, in place of a world."""
    percepts = [_percept(*sensed[at : at + 3]) for at in range(0, len(sensed), 3)]
    return Recorded(percepts, _told(told))


def log_of_run(
    world: ByteWorld | Recorded,
    player: Player,
    choices: Choices,
    budget: int,
    beat: MutableSequence[int],
) -> bytes | None:
    """The log of one run; None if the machine may have made it go wrong."""
    log = bytearray()
    run = None
    beat[1] = 1
    try:
        run = player(world.first, choices, world.told)
        _write_log(log, run, world, budget, beat)
    except StopIteration as stop:
        log += entry_of_answer(stop.value)
    except BaseException as error:  # noqa: BLE001  # an explorer may raise anything
        let_users_interrupt(error)
        machine = type(error) is ExplorerFault and error.machine
        if machine or isinstance(error, MemoryError):
            return None
        log.append(LogEnd.WITHOUT_ANSWER)
    finally:
        closed(run)
        beat[1] = 0
    return bytes(log)


def _write_log(
    log: bytearray,
    run: Generator[Any, Any, Any],
    world: ByteWorld | Recorded,
    budget: int,
    beat: MutableSequence[int],
) -> None:
    """Append every action of the run to the log; the answer arrives as StopIteration."""
    motions_left, shown_left, turn = budget, budget + 1, 1
    state, degree = world.initial, world.first.degree
    reply: Percept | None = None
    while True:
        message = run.send(reply)
        turn += 1
        beat[1] = turn
        if type(message) is Move:
            if not motions_left:
                log.append(LogEnd.OVER_BUDGET)
                return
            motions_left -= 1
            motion = motion_of(message, degree)
            log.append(motion)
            try:
                state, reply = world.step(state, motion)
            except IllegalAction:  # the record ends here
                log.append(LogEnd.STRANGE)
                return
            degree = reply.degree
        elif type(message) is Checkpoint:
            if not shown_left:
                log.append(LogEnd.SHOWN_TOO_OFTEN)
                return
            shown_left -= 1
            log += entry_of_checkpoint(message)
            reply = None
        else:
            log.append(LogEnd.WITHOUT_ANSWER)
            return


def _percept(degree: int, marks: int, bearing: int) -> Percept:
    return Percept(degree, marks, bearing - 1 if bearing else None)


def _told(told: int) -> int | None:
    return None if told < 0 else told
