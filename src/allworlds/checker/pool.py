"""The parent's side: handing out units, and outliving the workers that do them."""

from __future__ import annotations

import json
import mmap
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from typing import Any, Protocol, Self

from allworlds.checker.examine import Examiner, examine_unit
from allworlds.checker.scope import LEAST_TIMEOUT, Limits, Scope, Work
from allworlds.checker.tally import Tally
from allworlds.checker.worker import BEAT_WORDS, NO_RUN, HarnessError, Part, Setup, UnitJob
from allworlds.errors import InputError
from allworlds.subjects import Subject, SubjectError

_START = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); "
    "from allworlds.checker.worker import main; main(sys.argv[2:])"
)

POLL = LEAST_TIMEOUT
"""Seconds between two looks at silent workers."""

GRACE = 2.0
"""Seconds more where the parent is not the first to know: for a foreign program, whose silence
its worker notices itself, and for a worker that has still something to be heard."""


class TimeIsUp(Exception):
    """The time limit of the whole check has been reached."""


@dataclass(frozen=True, slots=True)
class Poisoned:
    """A run that cost a worker its life: the explorer was silent, or the interpreter died."""

    unit: Work
    number: int
    law: str
    seen: str


class Pool(Protocol):
    """Examines units, in any order."""

    def examine(self, scope: Scope, units: Iterable[Work], keep: int) -> Iterator[Tally | Poisoned]:
        """Tallies of parts, as they come, and the runs that could not be finished."""


class LocalPool:
    """Examines units in this process: for explorers that no other process can import.

    A silent explorer cannot be stopped here.
    """

    def __init__(self, subject: Subject, deadline: float | None) -> None:
        self._subject, self._deadline = subject, deadline

    def examine(self, scope: Scope, units: Iterable[Work], keep: int) -> Iterator[Tally | Poisoned]:
        """The units one after the other."""
        beat = [0, 0]
        examiner = Examiner(self._subject, scope.rules, beat)
        for unit in units:
            for _, tally in examine_unit(examiner, scope, unit, keep, beat):
                yield tally
                check_deadline(self._deadline)


class WorkerProcess:
    """A worker with its pipe and the memory in which its heart beats.

    Args:
        subject: the explorer, which the worker finds by its name.
        limits: patience and memory.
        hash_seed: of the interpreter.  All workers have the same, so that an explorer that
            depends on the order of a set does the same in each; another one tells.
    """

    def __init__(self, subject: Subject, limits: Limits, hash_seed: int = 0) -> None:
        self.silence = f"silent for {limits.answer_timeout:g} s"
        self.patience = limits.answer_timeout + (GRACE if subject.program else 0.0)
        self.connection, theirs = Pipe()
        with tempfile.TemporaryFile() as memory:
            memory.truncate(8 * BEAT_WORDS)
            self._memory = mmap.mmap(memory.fileno(), 8 * BEAT_WORDS)
            self.beat = memoryview(self._memory).cast("Q")
            self.process = subprocess.Popen(  # noqa: S603  # our own module
                [
                    sys.executable,
                    "-c",
                    _START,
                    json.dumps(sys.path),
                    str(theirs.fileno()),
                    str(memory.fileno()),
                ],
                stdin=subprocess.DEVNULL,
                pass_fds=(theirs.fileno(), memory.fileno()),
                # A Ctrl-C is for the parent; and what an explorer leaves behind dies with it.
                start_new_session=True,
                env={**os.environ, "PYTHONHASHSEED": str(hash_seed)},
            )
        theirs.close()
        self._program = subject.program is not None
        self._seen: tuple[int, int] = (0, 0)
        self._since = time.monotonic()
        self.beat[0] = NO_RUN
        self.send(Setup(subject.name, limits.answer_timeout, limits.memory))

    def send(self, job: object) -> None:
        """Hand over a job."""
        self.connection.send(job)

    def receive(self) -> Any:
        """The next message; waits for it.

        Raises:
            EOFError: if the process has ended.
            InputError: if the explorer could not be loaded there, or a bound has no value.
            HarnessError: if the worker itself has failed.
        """
        message = self.connection.recv()
        if isinstance(message, InputError | HarnessError):
            raise message
        return message

    def is_silent(self, grace: float = 0.0) -> bool:
        """The explorer has been thinking about one and the same turn for too long.

        ``grace`` seconds more are allowed where there is reason to.
        """
        now, seen = time.monotonic(), (self.beat[0], self.beat[1])
        if seen[1] == 0 or seen != self._seen:
            self._seen, self._since = seen, now
            return False
        return now - self._since > self.patience + grace

    def has_ended(self) -> bool:
        """The process is no more, and all that it has said has been heard.

        The pipe alone does not tell: a process forked by the explorer may hold it open.
        """
        return self.process.poll() is not None and not self.connection.poll()

    def death(self) -> str:
        """How the process ended, as a sentence."""
        try:
            code = self.process.wait(GRACE)
        except subprocess.TimeoutExpired:
            return "the end of the interpreter's pipe"
        how = f"exit code {code}" if code >= 0 else f"signal {-code}"
        return f"the end of the interpreter ({how})"

    def kill(self) -> None:
        """End the process now, and all that it has started."""
        if self._program:
            # The worker alone knows the program, which stands in a session of its own.
            self.process.terminate()
            with suppress(subprocess.TimeoutExpired):
                self.process.wait(GRACE)
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.connection.close()
        self.beat.release()
        self._memory.close()


@dataclass(slots=True)
class _Task:
    """A unit with how far it has been tallied, and the runs that are not to be tried again."""

    unit: Work
    start: int = 0
    skip: frozenset[int] = frozenset()


@dataclass(slots=True)
class WorkerPool:
    """Examines units in worker processes.

    Attributes:
        subject: the explorer, known to the workers by its name.
        limits: how many workers, and for how long.
        deadline: on the monotonic clock, or None.
    """

    subject: Subject
    limits: Limits
    deadline: float | None = None
    _idle: list[WorkerProcess] = field(default_factory=list)
    _busy: dict[Connection, tuple[WorkerProcess, _Task]] = field(default_factory=dict)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for worker in (*self._idle, *(worker for worker, _ in self._busy.values())):
            worker.kill()
        self._idle.clear()
        self._busy.clear()

    def examine(self, scope: Scope, units: Iterable[Work], keep: int) -> Iterator[Tally | Poisoned]:
        """The units, as many at a time as there are workers."""
        waiting = (_Task(unit) for unit in units)
        task = next(waiting, None)
        while task or self._busy:
            while task and len(self._busy) < self.limits.workers:
                self._hand_out(scope, task, keep)
                task = next(waiting, None)
            for connection in wait(list(self._busy), POLL):
                assert isinstance(connection, Connection)
                yield from self._hear(connection, scope, keep)
            for worker, _ in list(self._busy.values()):
                if worker.is_silent():
                    yield self._bury(worker, scope, keep, "timeout", worker.silence)
                elif worker.has_ended():
                    yield self._bury(worker, scope, keep, "crash", worker.death())
            check_deadline(self.deadline)

    def _hand_out(self, scope: Scope, task: _Task, keep: int) -> None:
        worker = self._idle.pop() if self._idle else WorkerProcess(self.subject, self.limits)
        # The number of a run within another unit would name a wrong world.
        worker.beat[0] = task.start if worker.beat[0] != NO_RUN else NO_RUN
        self._busy[worker.connection] = (worker, task)
        worker.send(UnitJob(scope, task.unit, keep, task.start, task.skip))

    def _hear(self, connection: Connection, scope: Scope, keep: int) -> Iterator[Tally | Poisoned]:
        worker, task = self._busy[connection]
        try:
            part = worker.receive()
        except (EOFError, ConnectionResetError):
            yield self._bury(worker, scope, keep, "crash", worker.death())
            return
        assert isinstance(part, Part)
        task.start = part.next_run
        if part.last:
            del self._busy[connection]
            self._idle.append(worker)
        yield part.tally

    def _bury(
        self, worker: WorkerProcess, scope: Scope, keep: int, law: str, seen: str
    ) -> Poisoned:
        """Replace a worker; its task goes on, from where it was tallied, without that run."""
        _, task = self._busy.pop(worker.connection)
        number = worker.beat[0]
        worker.kill()
        if number == NO_RUN:
            memory = self.limits.memory
            limit = "" if memory is None else f", with memory limited to {memory} MB"
            raise SubjectError(
                f"a worker came to {seen} before its first run of the explorer{limit}"
            )
        # A death between two runs is put down to the next one, so that the task gets on.
        number = max(number, task.start)
        while number in task.skip:
            number += 1
        again = _Task(task.unit, task.start, task.skip | {number})
        self._hand_out(scope, again, keep)
        return Poisoned(task.unit, number, law, seen)


def check_deadline(deadline: float | None) -> None:
    """Nothing before the deadline.

    Raises:
        TimeIsUp: after it.
    """
    if deadline is not None and time.monotonic() > deadline:
        raise TimeIsUp
