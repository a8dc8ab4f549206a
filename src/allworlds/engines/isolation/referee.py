"""The process that judges units; the foreign code is in its players."""

from __future__ import annotations

import traceback
from collections.abc import MutableSequence
from multiprocessing.connection import Connection
from random import Random

from allworlds.engines.isolation.cast import Cast, Unsettled, UserEngine
from allworlds.engines.isolation.jobs import Appointment, Casting, HarnessError, Tallied, UnitJob
from allworlds.engines.isolation.process import Guardian, limit_memory
from allworlds.engines.python.python_engine import (
    EnginesDisagree,
    PartwiseEngine,
    PythonEngine,
    WorkerEngine,
)
from allworlds.engines.python.second_play import Earlier, PlayedTwice
from allworlds.engines.transports.inline import with_last
from allworlds.explorers import built_in
from allworlds.inputs import InputError


class RefereeProcess:
    """A referee's life: its appointment, then units until the pipe is closed.

    ``beat[1]`` grows while it works, so that its owner can see that it does.
    """

    def __init__(
        self, connection: Connection, beat: MutableSequence[int], guardian: Guardian
    ) -> None:
        self._connection, self._beat, self._guardian = connection, beat, guardian
        self._remarks: list[str] = []
        self._earlier = Earlier()

    def run(self) -> None:
        """Serve until the owner hangs up."""
        appointment: Appointment = self._connection.recv()
        if appointment.memory is not None and not appointment.subject.from_user:
            try:
                limit_memory(appointment.memory)
            except InputError as error:
                self._connection.send(error)
                return
        cast = self._cast(appointment)
        # One engine as long as the same is asked: it learns how long runs take.
        engine: tuple[WorkerEngine, PartwiseEngine] | None = None
        try:
            while True:
                job: UnitJob = self._connection.recv()
                self._alive()
                if engine is None or engine[0] != job.examination:
                    engine = job.examination, self._engine(appointment, cast, job.examination)
                self._examine(engine[1], job)
                self._beat[1] = 0
        except EOFError:
            cast.close()

    def _cast(self, appointment: Appointment) -> Cast:
        subject = appointment.subject
        casting = Casting(
            subject.name, subject.source, appointment.answer_timeout, appointment.memory
        )
        order = Random(appointment.order)  # noqa: S311  # drawn from the system by the owner
        return Cast(self._guardian, casting, order, self._alive, self._remarks.append)

    def _engine(
        self, appointment: Appointment, cast: Cast, examination: WorkerEngine
    ) -> PartwiseEngine:
        subject = appointment.subject
        if not subject.from_user:
            return examination.for_built_in(built_in(subject.name), self._beat)
        if isinstance(examination, PythonEngine):
            return PlayedTwice(examination, subject.name, cast, self._earlier)
        assert isinstance(examination, UserEngine)
        return examination.for_user(subject.name, cast, self._earlier)

    def _examine(self, engine: PartwiseEngine, job: UnitJob) -> None:
        try:
            for (next_run, result), last in with_last(engine.parts(job.unit, job.start)):
                self._alive()
                for remark in self._remarks:
                    result.remark(remark)
                self._remarks.clear()
                self._connection.send(Tallied(next_run, result, last))
        except (InputError, Unsettled, EnginesDisagree) as error:
            self._connection.send(error)
        except OSError:
            raise
        except Exception:  # noqa: BLE001  # explorers' errors never get here: it is ours
            self._connection.send(HarnessError(traceback.format_exc()))

    def _alive(self) -> None:
        self._beat[1] += 1
