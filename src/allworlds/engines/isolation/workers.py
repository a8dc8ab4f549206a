"""The transport into worker processes: referees do units, which survive the loss of a referee."""

from __future__ import annotations

import secrets
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import islice
from multiprocessing.connection import Connection, wait
from random import Random
from typing import Any, Self

from msgspec import Struct, field

from allworlds.engines.isolation.failures import Unsettled
from allworlds.engines.isolation.one_player import STOPPED
from allworlds.engines.isolation.process import (
    WAKE,
    Guardian,
    Process,
    close_all,
    guardian,
)
from allworlds.engines.isolation.process_tree import Stops
from allworlds.engines.isolation.referee_jobs import RefereeSetup, UnitJob, UnitProgress
from allworlds.engines.isolation.worker_engine import WorkerEngine
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.run_counter import EnginesDisagree
from allworlds.engines.python.runs_of_unit import UnitOfRuns
from allworlds.engines.python.tally import Tally
from allworlds.engines.transports.inline import with_last
from allworlds.engines.units.effort import POLL, Limits, check_deadline
from allworlds.engines.units.unit import PartialResult, Transport
from allworlds.explorers import Subject

PATIENCE = 60.0
"""Seconds after which a referee without a heartbeat is replaced."""

AT_A_TIME = 4096
"""The number of units among which the order is drawn."""

MOST_ATTEMPTS = 3
"""The number of referees that are lost over one unit before it is given up."""


class _UnitTask(Struct):
    """A unit, and the run from which on it is still to be tallied."""

    unit: UnitOfRuns
    start: int = 0


class Workers(Struct):
    """The transport into processes of their own.

    A worker is a referee with its players.  A user's code can kill the players, but not their
    referee; if a referee is lost, the machine is the cause, and its unit is done again.

    Attributes:
        subject: the explorer, which the players find by its name.
        limits: the number of workers, and the time.
        deadline: on the monotonic clock, or None.
    """

    subject: Subject
    limits: Limits
    deadline: float | None = None
    _guardian: Guardian = field(default_factory=guardian)
    _idle: list[Process] = field(default_factory=list)
    _busy: dict[Connection, tuple[Process, _UnitTask]] = field(default_factory=dict)
    _lost: Counter[str] = field(default_factory=Counter)
    _stops: Stops = field(default_factory=Stops)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        close_all(*self._idle, *(referee for referee, _ in self._busy.values()))
        self._idle.clear()
        self._busy.clear()

    def map(
        self, engine: WorkerEngine, units: Iterable[UnitOfRuns]
    ) -> Iterator[PartialResult[UnitOfRuns, Any]]:
        """Yield the results of the units, as many at a time as there are workers.

        Raises:
            TimeIsUp: when the time limit has been reached.
            InputError: if the explorer cannot be loaded in a player.
            Unsettled: if processes are lost again and again.
            EnginesDisagree: if two engines disagree about a native explorer.
        """
        # An explorer that counts its runs is not to know of which unit they are.
        order = in_any_order(units) if self.subject.from_user else units
        waiting = (_UnitTask(unit) for unit in order)
        task, look_at = next(waiting, None), 0.0
        while task or self._busy:
            while task and len(self._busy) < self.limits.workers:
                self._hand_out(engine, task)
                task = next(waiting, None)
            for connection in wait(list(self._busy), POLL):
                assert isinstance(connection, Connection)
                yield self._receive(connection, engine)
            if time.monotonic() >= look_at:
                yield from self._look_at_referees(engine)
                look_at = time.monotonic() + POLL
            check_deadline(self.deadline)

    def _look_at_referees(self, engine: WorkerEngine) -> Iterator[PartialResult[UnitOfRuns, Any]]:
        """Wake referees that are silent, and replace those that are lost."""
        for referee, _ in list(self._busy.values()):
            if referee.silent_for() > WAKE:
                if self._stops.too_many(referee.pid):
                    raise Unsettled(STOPPED)
                referee.wake()
            if referee.silent_for() > PATIENCE:
                yield self._replace(referee, engine, f"silent for {PATIENCE:g} s")
            elif referee.has_ended():
                yield self._replace(referee, engine, referee.death()[0])

    def _hand_out(self, engine: WorkerEngine, task: _UnitTask) -> None:
        referee = self._idle.pop() if self._idle else self._new_referee()
        referee.beat[0] = 0
        self._busy[referee.connection] = (referee, task)
        referee.send(UnitJob(engine, task.unit, task.start))

    def _new_referee(self) -> Process:
        setup = RefereeSetup(self.subject, self.limits, secrets.randbits(64))
        return Process(self._guardian, "referee", setup)

    def _receive(
        self, connection: Connection, engine: WorkerEngine
    ) -> PartialResult[UnitOfRuns, Any]:
        referee, task = self._busy[connection]
        try:
            message = referee.receive()
        except EOFError:
            return self._replace(referee, engine, referee.death()[0])
        if isinstance(message, Unsettled | EnginesDisagree):
            raise message
        assert isinstance(message, UnitProgress)
        task.start = message.next_run
        if message.last:
            del self._busy[connection]
            self._idle.append(referee)
        return PartialResult(task.unit, message.result, message.last)

    def _replace(
        self, referee: Process, engine: WorkerEngine, how: str
    ) -> PartialResult[UnitOfRuns, Tally]:
        """Go on with another referee, from the first run that is not tallied."""
        _, task = self._busy.pop(referee.connection)
        referee.close()
        self._lost[task.unit.key] += 1
        if self._lost[task.unit.key] >= MOST_ATTEMPTS:
            raise Unsettled(f"{MOST_ATTEMPTS} processes were lost over one unit, the last by {how}")
        self._hand_out(engine, task)
        tally = engine.tally()
        tally.remark(f"a referee was lost ({how}); its unit went on in another")
        return PartialResult(task.unit, tally, last=False)


class ThisProcess(Struct, frozen=True):
    """The transport for an explorer that no other process can find; it cannot be stopped here."""

    subject: Subject
    deadline: float | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Leave the context; there is no process to end."""

    def map(
        self, engine: PythonEngine, units: Iterable[UnitOfRuns]
    ) -> Iterator[PartialResult[UnitOfRuns, Tally]]:
        """Yield the results of the units, one unit after the other."""
        subject = self.subject
        bound = engine.for_built_in(subject)
        if subject.from_user:
            players = InProcessPlayers(subject)
            bound, units = engine.for_users(subject.name, players), in_any_order(units)
        for unit in units:
            for (_, tally), last in with_last(bound.parts(unit)):
                yield PartialResult(unit, tally, last)
                check_deadline(self.deadline)


def in_any_order(units: Iterable[UnitOfRuns]) -> Iterator[UnitOfRuns]:
    """The units in an order that is drawn anew each time, :data:`AT_A_TIME` of them at a time."""
    every, order = iter(units), Random(secrets.randbits(64))  # noqa: S311  # as it is drawn from the system
    while some := list(islice(every, AT_A_TIME)):
        order.shuffle(some)
        yield from some


def workers_for(
    subject: Subject, limits: Limits, deadline: float | None = None
) -> Transport[PythonEngine]:
    """Worker processes if the explorer can be imported by name, else this process."""
    if subject.importable or not subject.from_user:
        return Workers(subject, limits, deadline)
    return ThisProcess(subject, deadline)
