"""Stretches played by explorers that are generators: a function in Python, a program behind a pipe.

What a run did is left behind as the bytes that the kernel reads
(:mod:`allworlds.engines.kernel.logs`), so that explorers of every kind are judged by the same
compiled judge.  The twin of :func:`played` is :func:`allworlds.judging.episode.perform`, which can
also say what went wrong; it is asked where something did.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, MutableSequence
from random import Random
from typing import Any, Protocol

from allworlds.engines.isolation.jobs import PlayStretch, Stretched
from allworlds.engines.isolation.shared_logs import Shown
from allworlds.engines.kernel.writing import LogEnd, answer_entry, shown_entry
from allworlds.inputs import integer, let_users_interrupt
from allworlds.judging import UncheckedAnswer, closed, ending_of, integers
from allworlds.protocol import (
    Ambiguous,
    Checkpoint,
    Choices,
    ExplorerFault,
    Move,
    Percept,
    Player,
    policy_named,
)


class Scribe:
    """A player's side of stretches, for a generator that is here.

    Args:
        player: the explorer.
        beat: ``beat[0]`` is set to the number of each run; see
            :func:`allworlds.judging.episode.play`.
        intact: called after each play, to look at what the explorer may have broken.
    """

    def __init__(
        self, player: Player, beat: MutableSequence[int], intact: Callable[[], None]
    ) -> None:
        self._player, self._beat, self._intact = player, beat, intact
        self._shown = Shown()

    def play(self, job: PlayStretch) -> Stretched:
        """All runs of a stretch, whose logs come to stand in the memory.

        There are none if there is no room, or if the machine may have had its part in one of them.
        """
        stretch = self._shown.stretch(job)
        heads = stretch.heads[: job.runs].tolist()
        logs, begins = bytearray(), [0] * job.runs
        order = [*range(job.runs)]
        Random(job.order).shuffle(order)  # noqa: S311  # it need not be secret for longer than a run
        for run in order:
            budget, told, number, motions = heads[run]
            self._beat[0], begins[run] = number, len(logs)
            scene: ByteStage
            if job.again:
                start = int(stretch.starts[run])
                sensed = stretch.percepts[start : start + 3 * (motions + 1)].tobytes()
                scene = RecordedBytes(sensed, told)
            else:
                scene = Tabled(stretch.worlds[run].tobytes(), told)
            choices = Choices(policy_named(job.policy))
            log = played(scene, self._player, choices, budget, self._beat)
            self._intact()
            if log is None:
                return Stretched(-1, 0)
            logs += log
        return Stretched(stretch.put(logs, begins), 0)


class ByteStage(Protocol):
    """What is sensed, three bytes each: the degree, the marks, and the bearing and one more.

    Attributes:
        first: before any motion.
        told: what the lighthouse tells before the start; below 0: nothing.
    """

    first: bytes
    told: int

    def leave(self, motion: int) -> bytes:
        """Behind a motion, which is below the degree; nothing where a record ends."""


class Tabled:
    """A world as the kernel lays it out: five bytes for each dart."""

    def __init__(self, table: bytes, told: int) -> None:
        self._table, self._dart = table, 0
        self.first, self.told = table[2:5], told

    def leave(self, motion: int) -> bytes:
        """See :class:`ByteStage`."""
        table, leaving = self._table, self._dart + motion
        first, _, degree = table[5 * self._dart : 5 * self._dart + 3]
        if leaving >= first + degree:
            leaving -= degree
        self._dart = arrived = table[5 * leaving + 1]
        return table[5 * arrived + 2 : 5 * arrived + 5]


class RecordedBytes:
    """In place of a world: what was sensed in the first play."""

    def __init__(self, sensed: bytes, told: int) -> None:
        self._sensed, self._at = sensed, 0
        self.first, self.told = sensed[:3], told

    def leave(self, motion: int) -> bytes:  # noqa: ARG002  # what is sensed is known
        """See :class:`ByteStage`."""
        self._at = at = self._at + 3
        return self._sensed[at : at + 3]


def played(
    scene: ByteStage, player: Player, choices: Choices, budget: int, beat: MutableSequence[int]
) -> bytes | None:
    """The log of one run; None if what went wrong may be the machine's doing."""
    log = bytearray()
    told = None if scene.told < 0 else scene.told
    run = None
    beat[1] = 1
    try:
        run = player(_percept(*scene.first), choices, told)
        _write(log, run, scene, budget, beat)
    except StopIteration as stop:
        log += _answer(stop.value)
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


def _write(
    log: bytearray,
    run: Generator[Any, Any, Any],
    scene: ByteStage,
    budget: int,
    beat: MutableSequence[int],
) -> None:
    """All that the run does comes to stand in the log, but for the answer: StopIteration has it."""
    motions_left, shown_left, turn = budget, budget + 1, 1
    degree, reply = scene.first[0], None
    while True:
        message = run.send(reply)
        turn += 1
        beat[1] = turn
        if type(message) is Move:
            if not motions_left:
                log.append(LogEnd.OVER_BUDGET)
                return
            motions_left -= 1
            k = message.k
            motion = (k if type(k) is int else integer(k)) % degree
            log.append(motion)
            sensed = scene.leave(motion)
            if not sensed:
                log.append(LogEnd.STRANGE)
                return
            reply = _percept(*sensed)
            degree = reply.degree
        elif type(message) is Checkpoint:
            if not shown_left:
                log.append(LogEnd.SHOWN_TOO_OFTEN)
                return
            shown_left -= 1
            sigma, alpha = integers(message.sigma), integers(message.alpha)
            log += shown_entry(sigma, alpha, integer(message.here))
            reply = None
        else:
            log.append(LogEnd.WITHOUT_ANSWER)
            return


def _percept(degree: int, marks: int, bearing: int) -> Percept:
    return Percept(degree, marks, bearing - 1 if bearing else None)


def _answer(answer: object) -> bytes:
    if type(answer) is Ambiguous:
        return bytes((LogEnd.STRANGE,))
    said = ending_of(answer)
    if type(said) is not UncheckedAnswer:
        return bytes((LogEnd.WITHOUT_ANSWER,))
    return answer_entry(said.sigma, said.alpha, said.here)
