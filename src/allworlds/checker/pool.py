"""The parent's side: handing out units, and outliving the workers that do them."""

from __future__ import annotations

import json
import mmap
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from types import TracebackType
from typing import Any, Protocol, Self

from allworlds.checker.examine import Examiner, examine_unit
from allworlds.checker.scope import Limits, Scope, Work
from allworlds.checker.tally import Tally
from allworlds.checker.worker import BEAT_WORDS, NO_RUN, HarnessError, Part, Setup, UnitJob
from allworlds.subjects import Subject, SubjectError

_START = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); "
    "from allworlds.checker.worker import main; main(sys.argv[2:])"
)

POLL = 0.1
"""Seconds between two looks at silent workers."""

GRACE = 2.0
"""Seconds more for a foreign program, whose silence its worker notices itself."""


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
                _check_deadline(self._deadline)


class WorkerProcess:
    """A worker with its pipe and the memory in which its heart beats."""

    def __init__(self, subject: Subject, limits: Limits) -> None:
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
            )
        theirs.close()
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
            SubjectError: if the explorer could not be loaded there.
            HarnessError: if the worker itself has failed.
        """
        message = self.connection.recv()
        if isinstance(message, SubjectError | HarnessError):
            raise message
        return message

    def is_silent(self) -> bool:
        """The explorer has been thinking about one and the same turn for too long."""
        now, seen = time.monotonic(), (self.beat[0], self.beat[1])
        if seen[1] == 0 or seen != self._seen:
            self._seen, self._since = seen, now
            return False
        return now - self._since > self.patience

    def death(self) -> str:
        """How the process ended, as a sentence."""
        code = self.process.wait()
        how = f"exit code {code}" if code >= 0 else f"signal {-code}"
        return f"the end of the interpreter ({how})"

    def kill(self) -> None:
        """End the process now."""
        self.process.kill()
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

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
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
                    seen = f"silent for {self.limits.answer_timeout:g} s"
                    yield self._bury(worker, scope, keep, "timeout", seen)
            _check_deadline(self.deadline)

    def _hand_out(self, scope: Scope, task: _Task, keep: int) -> None:
        worker = self._idle.pop() if self._idle else WorkerProcess(self.subject, self.limits)
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
            raise SubjectError(f"a worker came to {seen} before its first run of the explorer")
        # A death between two runs is put down to the next one, so that the task gets on.
        number = max(number, task.start)
        while number in task.skip:
            number += 1
        again = _Task(task.unit, task.start, task.skip | {number})
        self._hand_out(scope, again, keep)
        return Poisoned(task.unit, number, law, seen)


def _check_deadline(deadline: float | None) -> None:
    if deadline is not None and time.monotonic() > deadline:
        raise TimeIsUp
