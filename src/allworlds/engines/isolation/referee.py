"""The process that judges units; the user's code is in its players."""

from __future__ import annotations

import traceback
from collections.abc import MutableSequence
from multiprocessing.connection import Connection
from random import Random

from allworlds.engines.isolation.failures import HarnessError, Unsettled
from allworlds.engines.isolation.jobs import PlayerSetup
from allworlds.engines.isolation.memory_limit import limit_memory
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.process import Guardian
from allworlds.engines.isolation.referee_jobs import RefereeSetup, UnitJob, UnitProgress
from allworlds.engines.isolation.worker_engine import WorkerEngine
from allworlds.engines.python.run_counter import EnginesDisagree, PartwiseEngine
from allworlds.engines.transports.inline import with_last
from allworlds.explorers import built_in
from allworlds.inputs import InputError


class RefereeProcess:
    """A referee: it receives its setup, then units until the pipe is closed.

    ``beat[1]`` grows while it works, as a heartbeat for its owner.
    """

    def __init__(
        self, connection: Connection, beat: MutableSequence[int], guardian: Guardian
    ) -> None:
        self._connection, self._beat, self._guardian = connection, beat, guardian
        self._remarks: list[str] = []

    def run(self) -> None:
        """Serve until the owner hangs up."""
        setup: RefereeSetup = self._connection.recv()
        if setup.limits.memory is not None and not setup.subject.from_user:
            try:
                limit_memory(setup.limits.memory)
            except InputError as error:
                self._connection.send(error)
                return
        players = self._players(setup)
        # One engine as long as the same is asked for: it learns how long runs take.
        bound: tuple[WorkerEngine, PartwiseEngine] | None = None
        try:
            while True:
                job: UnitJob = self._connection.recv()
                self._alive()
                if bound is None or bound[0] != job.engine:
                    bound = job.engine, self._bind(job.engine, setup, players)
                self._do(bound[1], job)
                self._beat[1] = 0
        except EOFError:
            players.close()

    def _players(self, setup: RefereeSetup) -> PlayerPair:
        order = Random(setup.order)  # noqa: S311  # drawn from the system by the owner
        each = PlayerSetup.of(setup.subject, setup.limits)
        return PlayerPair(self._guardian, each, order, self._alive, self._remarks.append)

    def _bind(
        self, engine: WorkerEngine, setup: RefereeSetup, players: PlayerPair
    ) -> PartwiseEngine:
        """The engine with its explorer: a built-in one is played here, a user's by players."""
        subject = setup.subject
        if not subject.from_user:
            return engine.for_built_in(built_in(subject.name), self._beat)
        return engine.for_users(subject.name, players)

    def _do(self, engine: PartwiseEngine, job: UnitJob) -> None:
        try:
            for (next_run, result), last in with_last(engine.parts(job.unit, job.start)):
                self._alive()
                for remark in self._remarks:
                    result.remark(remark)
                self._remarks.clear()
                self._connection.send(UnitProgress(next_run, result, last))
        except (InputError, Unsettled, EnginesDisagree) as error:
            self._connection.send(error)
        except OSError:
            raise
        except Exception:  # noqa: BLE001  # explorers' errors never get here: it is ours
            self._connection.send(HarnessError(traceback.format_exc()))

    def _alive(self) -> None:
        self._beat[1] += 1
