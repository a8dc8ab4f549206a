"""The process with the foreign code in it: it plays, and judges nothing."""

from __future__ import annotations

import hashlib
import inspect
import os
import signal
import time
import traceback
from collections.abc import Callable, MutableSequence, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from allworlds.engines.isolation.jobs import (
    Casting,
    Described,
    HarnessError,
    Played,
    PlayRecords,
    PlayRuns,
    PlayStretch,
    Stretched,
    Trace,
    TraceEvent,
)
from allworlds.engines.isolation.messages import Message, written
from allworlds.engines.isolation.process import address_space, limit_memory
from allworlds.engines.python.examiner import name_run
from allworlds.engines.python.play import Stagehand
from allworlds.explorers import Subject, load
from allworlds.inputs import InputError
from allworlds.judging import Fault, Log, perform
from allworlds.protocol import Action, Choices, Kind, Percept, Schedules, number_of
from allworlds.world import State, World

if TYPE_CHECKING:
    from allworlds.engines.isolation.scribe import Scribe
    from allworlds.engines.isolation.shared_logs import Actor

T = TypeVar("T")

CHUNK, CHUNK_SECONDS = 64, 0.1
"""So many logs, or seconds, after which some are handed over."""

NATIVE_MEMORY = 2048
"""MB of address space that a shared library has, unless another limit is named."""

TIMERS = (signal.ITIMER_REAL, signal.ITIMER_VIRTUAL, signal.ITIMER_PROF)
"""What an explorer may leave behind to go off when it is not its turn."""

LOOK = 0.002
"""Seconds between two looks at timers and pipe: each costs as much as a short run."""

Job = PlayRuns | PlayRecords | PlayStretch | Trace
"""Everything that a player can be asked to do after its casting."""


class PlayerProcess:
    """A player's life: its casting, then jobs until the pipe is closed."""

    def __init__(self, connection: Connection, beat: MutableSequence[int]) -> None:
        self._connection = connection
        self._beat = beat
        self._pid = os.getpid()
        self._actor: Actor | Scribe | None = None
        self._look_at = 0.0

    def run(self) -> None:
        """Serve until the owner hangs up."""
        casting: Casting = self._connection.recv()
        try:
            if casting.memory is not None:
                limit_memory(casting.memory)
            subject = load(casting.name, casting.answer_timeout, casting.source)
            if subject.native is not None and casting.memory is None:
                limit_memory(address_space() + NATIVE_MEMORY)
        except InputError as error:
            if casting.memory is not None and "memory" not in str(error):
                error = InputError(f"memory {casting.memory} MB is probably too small: {error}")
            self._say(error)
            return
        self._intact()
        signal.signal(signal.SIGTERM, lambda *_: _leave(subject))
        self._say(Described(subject.keywords, _digest(subject)))
        with subject.running():
            self._serve(subject, Stagehand(subject.player(), self._beat, self._intact))

    def _serve(self, subject: Subject, stagehand: Stagehand) -> None:
        while True:
            job = self._connection.recv()
            try:
                self._do(subject, stagehand, job)
                self._look()
            except OSError:
                raise
            except InputError as error:  # a bound without a value for some world
                self._say(error)
            except Exception:  # noqa: BLE001  # explorers' errors never get here: it is ours
                self._say(HarnessError(traceback.format_exc()))

    def _do(self, subject: Subject, stagehand: Stagehand, job: Job) -> None:
        match job:
            case PlayRuns():
                self._play(stagehand, job)
            case PlayRecords(records, policy, order):
                self._say(stagehand.again(records, policy, order))
            case PlayStretch():
                self._say(self._stretch(subject, job))
            case Trace():
                self._trace(subject, job)

    def _stretch(self, subject: Subject, job: PlayStretch) -> Stretched:
        from allworlds.engines.isolation.scribe import Scribe
        from allworlds.engines.isolation.shared_logs import Actor

        if self._actor is None:
            if subject.native is not None:
                self._actor = Actor(subject.native, self._beat)
            else:
                self._actor = Scribe(subject.player(), self._beat, self._intact)
        stretched = self._actor.play(job)
        self._intact()
        return stretched

    def _play(self, stagehand: Stagehand, job: PlayRuns) -> None:
        logs: list[tuple[int, Log]] = []
        done: list[int] = []
        due = time.monotonic() + CHUNK_SECONDS
        for number, log in stagehand.first(
            job.examination, job.unit, job.numbers, job.order, job.script
        ):
            if log is None:
                done.append(number)
            else:
                logs.append((number, log))
            if len(logs) >= CHUNK or time.monotonic() > due:
                self._say(Played(logs, done))
                logs, done = [], []
                due = time.monotonic() + CHUNK_SECONDS
        if logs or done:
            self._say(Played(logs, done))

    def _trace(self, subject: Subject, job: Trace) -> None:
        rules = job.rules
        name = name_run(rules, job.world)
        every = job.schedules == "all"
        for choices in Schedules() if every else [rules.choices(name, job.script)]:
            self._say(TraceEvent(None))
            log = perform(
                TellingWorld(job.world, self._say),
                subject.player(),
                TellingChoices(choices, self._say),
                rules.budget(job.world.map),
                self._beat,
            )
            self._intact()
        self._say([log])

    def _say(self, message: Message) -> None:
        self._connection.send_bytes(written(message))

    def _intact(self) -> None:
        """Leave, if the explorer has forked this process; now and then look at the rest, too."""
        if os.getpid() != self._pid:
            # The original goes on with the work; its copy must not do it a second time.
            os._exit(0)
        if time.monotonic() > self._look_at:
            self._look()

    def _look(self) -> None:
        """Leave, if the explorer has closed this process's pipe; stop its timers."""
        for timer in TIMERS:
            signal.setitimer(timer, 0)
        os.fstat(self._connection.fileno())
        self._look_at = time.monotonic() + LOOK


class TellingWorld:
    """A world that tells each step before the explorer sees its outcome."""

    def __init__(self, world: World, say: Callable[[Message], None]) -> None:
        self._world, self._say = world, say
        self.initial, self.first, self.told = world.initial, world.first, world.told

    def step(self, state: State, action: Action) -> tuple[State, Percept]:
        """The world's, told."""
        after, percept = self._world.step(state, action)
        self._say(TraceEvent((number_of(action), percept)))
        return after, percept


class TellingChoices(Choices):
    """Choices that tell each pick."""

    def __init__(self, choices: Choices, say: Callable[[Message], None]) -> None:
        super().__init__()
        self._choices, self._say = choices, say
        self.record = choices.record

    def pick(self, options: Sequence[T], of: Kind, cost: Sequence[int] | None = None) -> T:
        """One of the options, told."""
        picked = self._choices.pick(options, of, cost)
        self._say(TraceEvent(self.record[-1]))
        return picked


def _digest(subject: Subject) -> str:
    """SHA-256 of the explorer's file, or of the program's; empty where there is none."""
    if subject.source is not None:
        return subject.source.digest
    with suppress(Exception):  # whatever an explorer's module makes of being looked at
        if subject.native is not None:
            return subject.native.library.digest
        if subject.program is not None:
            return hashlib.sha256(Path(subject.program.path).read_bytes()).hexdigest()
        file = inspect.getsourcefile(inspect.unwrap(subject.explore))  # type: ignore[arg-type]
        return hashlib.sha256(Path(file or "").read_bytes()).hexdigest()
    return ""


def _leave(subject: Subject) -> None:
    """End this process now, but not without the foreign program behind the explorer."""
    if subject.program:
        subject.program.close()
    os._exit(0)


__all__ = ["Fault", "PlayerProcess"]
