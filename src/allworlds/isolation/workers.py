"""Units in worker processes, and outliving the workers that do them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from multiprocessing.connection import Connection, wait
from typing import Any, Self

from allworlds.inputs import InputError
from allworlds.isolation.confirm import finding_of_lost_run
from allworlds.isolation.jobs import NO_RUN, Tallied, UnitJob
from allworlds.isolation.process import WorkerProcess
from allworlds.runs import Examination, Examines, LocalExamination, Tally, Worlds
from allworlds.subjects import Subject
from allworlds.work import POLL, Here, Limits, Part, Transport, check_deadline


@dataclass(slots=True)
class _Task:
    """A unit with how far it has been tallied, and the runs that are not to be tried again."""

    unit: Worlds
    start: int = 0
    skip: frozenset[int] = frozenset()


@dataclass(slots=True)
class Workers:
    """The transport into processes of their own, which foreign code may kill.

    A run that costs a worker its life is a finding; a new worker goes on behind it.

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

    def map(self, engine: Examines, units: Iterable[Worlds]) -> Iterator[Part[Worlds, Any]]:
        """The units, as many at a time as there are workers.

        Raises:
            TimeIsUp: when the time limit has been reached.
            InputError: if the explorer cannot be loaded in a worker.
        """
        waiting = (_Task(unit) for unit in units)
        task = next(waiting, None)
        while task or self._busy:
            while task and len(self._busy) < self.limits.workers:
                self._hand_out(engine, task)
                task = next(waiting, None)
            for connection in wait(list(self._busy), POLL):
                assert isinstance(connection, Connection)
                yield self._hear(connection, engine)
            for worker, _ in list(self._busy.values()):
                if worker.is_silent():
                    yield self._replace(worker, engine, "timeout", worker.silence)
                elif worker.has_ended():
                    yield self._replace(worker, engine, "crash", worker.death())
            check_deadline(self.deadline)

    def _hand_out(self, engine: Examines, task: _Task) -> None:
        worker = self._idle.pop() if self._idle else WorkerProcess(self.subject, self.limits)
        # The number of a run within another unit would name a wrong world.
        worker.beat[0] = task.start if worker.beat[0] != NO_RUN else NO_RUN
        self._busy[worker.connection] = (worker, task)
        worker.send(UnitJob(engine, task.unit, task.start, task.skip))

    def _hear(self, connection: Connection, engine: Examines) -> Part[Worlds, Any]:
        worker, task = self._busy[connection]
        try:
            told = worker.receive()
        except (EOFError, ConnectionResetError):
            return self._replace(worker, engine, "crash", worker.death())
        assert isinstance(told, Tallied)
        task.start = told.next_run
        if told.last:
            del self._busy[connection]
            self._idle.append(worker)
        return Part(task.unit, told.result, told.last)

    def _replace(
        self, worker: WorkerProcess, engine: Examines, law: str, seen: str
    ) -> Part[Worlds, Tally]:
        """The finding of a lost run; its unit goes on, from where it was tallied, without it."""
        _, task = self._busy.pop(worker.connection)
        number = worker.beat[0]
        worker.kill()
        if number == NO_RUN:
            memory = self.limits.memory
            limit = "" if memory is None else f", with memory limited to {memory} MB"
            raise InputError(f"a worker came to {seen} before its first run of the explorer{limit}")
        # A death between two runs is put down to the next one, so that the task gets on.
        number = max(number, task.start)
        while number in task.skip:
            number += 1
        self._hand_out(engine, _Task(task.unit, task.start, task.skip | {number}))
        tally = Tally(engine.keep)
        tally.find(finding_of_lost_run(task.unit, number, engine.scope, self.subject, law, seen))
        return Part(task.unit, tally, last=False)


@dataclass(frozen=True, slots=True)
class ThisProcess:
    """The same for an explorer that no other process can import; it cannot be stopped here."""

    subject: Subject
    deadline: float | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Nothing is left."""

    def map(self, engine: Examination, units: Iterable[Worlds]) -> Iterator[Part[Worlds, Tally]]:
        """The units one after the other."""
        return Here(self.deadline).map(LocalExamination(engine, self.subject), units)


def workers_for(
    subject: Subject, limits: Limits, deadline: float | None = None
) -> Transport[Examination]:
    """Where an explorer's runs take place: as far away as it can be found."""
    if subject.importable:
        return Workers(subject, limits, deadline)
    return ThisProcess(subject, deadline)
