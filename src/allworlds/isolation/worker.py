"""A process that examines units, and that its parent can kill.

It is a program of its own, so that nothing of the parent but its import path is inherited:
no threads, no half-imported main module.  It speaks pickles over a pipe; what the explorer
prints goes to stderr.
"""

from __future__ import annotations

import mmap
import os
import signal
import sys
import traceback
from collections.abc import MutableSequence, Sequence
from multiprocessing.connection import Connection
from typing import cast

from allworlds.episode import Episode, play
from allworlds.inputs import InputError
from allworlds.isolation.jobs import (
    BEAT_WORDS,
    Ended,
    HarnessError,
    Job,
    ReplayJob,
    RunJob,
    Setup,
    Tallied,
    Traced,
    TraceJob,
    UnitJob,
)
from allworlds.isolation.standins import Recorded, TellingChoices, TellingWorld
from allworlds.protocol import Schedules
from allworlds.runs import Examiner
from allworlds.streams import patient_stderr
from allworlds.subjects import Subject, load
from allworlds.work import with_last


def replay_recorded(subject: Subject, job: ReplayJob, beat: MutableSequence[int]) -> Episode:
    """What the explorer does when it gets the recorded percepts again."""
    recorded = Recorded(job.transcript, job.told)
    choices = job.rules.choices("", job.choices)
    return play(recorded, subject.player(), choices, job.budget, beat)


class Worker:
    """One worker's life: a setup, then jobs until the pipe is closed."""

    def __init__(self, connection: Connection, beat: MutableSequence[int]) -> None:
        self._connection = connection
        self._beat = beat
        self._pid = os.getpid()

    def run(self) -> None:
        """Serve until the parent hangs up."""
        setup: Setup = self._connection.recv()
        try:
            if setup.memory is not None:
                _limit_memory(setup.memory)
            subject = load(setup.explorer, setup.answer_timeout)
        except InputError as error:
            if setup.memory is not None:
                # The parent has loaded it, without a limit.
                error = InputError(f"memory {setup.memory} MB is probably too small: {error}")
            self._connection.send(error)
            return
        signal.signal(signal.SIGTERM, lambda *_: _leave(subject))
        with subject.running():
            self._serve(subject)

    def _serve(self, subject: Subject) -> None:
        while True:
            try:
                job = self._connection.recv()
            except EOFError:
                return
            try:
                self._do(subject, job)
            except OSError:
                raise
            except InputError as error:  # a bound without a value for some world
                self._connection.send(error)
            except Exception:  # noqa: BLE001  # explorers' errors never get here: it is ours
                self._connection.send(HarnessError(traceback.format_exc()))

    def _do(self, subject: Subject, job: Job) -> None:
        match job:
            case UnitJob():
                self._examine(subject, job)
            case RunJob():
                self._run(subject, job)
            case TraceJob():
                self._trace(subject, job)
            case ReplayJob():
                self._end(replay_recorded(subject, job, self._beat))

    def _examine(self, subject: Subject, job: UnitJob) -> None:
        examiner = Examiner(subject, job.examination.scope.rules, self._beat, self._intact)
        parts = job.examination.parts(examiner, job.unit, job.start, job.skip)
        for part, last in with_last(parts):
            self._connection.send(Tallied(*part, last))

    def _intact(self) -> None:
        """Leave, if the explorer has forked this process or closed its pipe."""
        if os.getpid() != self._pid:
            # The original goes on with the work; its copy must not do it a second time.
            os._exit(0)
        os.fstat(self._connection.fileno())

    def _run(self, subject: Subject, job: RunJob) -> None:
        examiner = Examiner(subject, job.rules, self._beat, self._intact)
        name = examiner.name_run(job.world)
        choices = job.rules.choices(name, job.script)
        self._connection.send(examiner.examine(job.world, choices, name))

    def _trace(self, subject: Subject, job: TraceJob) -> None:
        rules = job.rules
        name = Examiner(subject, rules).name_run(job.world)
        every = job.schedules == "all"
        told_world = TellingWorld(job.world, self._connection)
        for choices in Schedules() if every else [rules.choices(name, job.script)]:
            self._connection.send(Traced(None))
            told = TellingChoices(choices, self._connection)
            episode = play(
                told_world,
                subject.player(),
                told,
                rules.budget(job.world.map),
                self._beat,
            )
            self._intact()
        self._end(episode)

    def _end(self, episode: Episode) -> None:
        self._connection.send(Ended(episode.transcript.actions, episode.ending))


def _limit_memory(megabytes: int) -> None:
    """Bound the address space of this process.

    Raises:
        InputError: if it is larger already; it would go on for as long as it needs no more.
    """
    import resource

    _, most = resource.getrlimit(resource.RLIMIT_AS)
    size = min(megabytes << 20, sys.maxsize if most == resource.RLIM_INFINITY else most)
    resource.setrlimit(resource.RLIMIT_AS, (size, size))
    try:
        mmap.mmap(-1, mmap.PAGESIZE).close()
    except OSError:
        raise InputError("a worker is larger before it has loaded an explorer") from None


def _leave(subject: Subject) -> None:
    """End this process now, but not without the foreign program behind the explorer."""
    if subject.program:
        subject.program.close()
    os._exit(0)


def main(arguments: Sequence[str]) -> None:
    """Entry of the process: the file descriptors of its pipe and of the shared memory."""
    pipe, memory = map(int, arguments)
    # Interrupts are the parent's business; and nothing an explorer prints may be lost in,
    # or get into, what the parent reads.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.dup2(2, 1)
    sys.stdout = sys.stderr = patient_stderr()
    with mmap.mmap(memory, 8 * BEAT_WORDS) as shared, Connection(pipe) as connection:
        beat = memoryview(shared).cast("Q")
        try:
            Worker(connection, cast("MutableSequence[int]", beat)).run()
        except OSError:
            # The parent has gone, or the explorer has closed the pipe: there is nobody to
            # report to, and the parent sees the end of the pipe.
            os._exit(1)
        finally:
            beat.release()
