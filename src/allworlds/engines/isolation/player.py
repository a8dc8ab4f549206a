"""The process with the user's code in it, which plays and does not judge."""

from __future__ import annotations

import hashlib
import inspect
import os
import signal
import time
import traceback
from collections.abc import MutableSequence
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING

from allworlds.engines.isolation.jobs import (
    PlayerSetup,
    PlayRecords,
    PlayRuns,
    PlayStretch,
    Trace,
)
from allworlds.engines.isolation.memory_limit import address_space, limit_memory
from allworlds.engines.isolation.messages import (
    ExplorerDescription,
    Failure,
    Message,
    RecordLogs,
    Refusal,
    StretchResult,
    write_message,
)
from allworlds.engines.python.play import ExplorerRunner
from allworlds.explorers import Shield, Subject, load
from allworlds.inputs import InputError
from allworlds.protocol import limit_calls

if TYPE_CHECKING:
    from allworlds.engines.isolation.generator_player import GeneratorPlayer
    from allworlds.engines.isolation.library_player import LibraryPlayer
    from allworlds.engines.isolation.world_player import WorldPlayer

NATIVE_MEMORY = 2048
"""MB of address space that a shared library has, unless another limit is named."""

TIMERS = (signal.ITIMER_REAL, signal.ITIMER_VIRTUAL, signal.ITIMER_PROF)
"""Timers that an explorer may leave behind to go off when it is not its turn."""

LOOK = 0.002
"""Seconds between two looks at timers and pipe: each costs as much as a short run."""

SHARE_OF_MODELS = 0.8
"""The share of an explorer's time for an answer that a call of a lighthouse or judge may take."""

Job = PlayRuns | PlayRecords | PlayStretch | Trace
"""Every message to a player after its setup."""


class PlayerProcess:
    """A player: it receives its setup, then jobs until the pipe is closed."""

    def __init__(self, connection: Connection, beat: MutableSequence[int]) -> None:
        self._connection = connection
        self._beat = beat
        self._pid = os.getpid()
        self._stretches: LibraryPlayer | GeneratorPlayer | None = None
        self._in_worlds: WorldPlayer | None = None
        self._look_at = 0.0

    def run(self) -> None:
        """Serve until the owner hangs up."""
        setup: PlayerSetup = self._connection.recv()
        # A silent model is given up before it looks like a silent explorer.
        limit_calls(SHARE_OF_MODELS * setup.answer_timeout)
        if setup.output:
            _print_to(os.devnull)
        try:
            if setup.memory is not None:
                limit_memory(setup.memory)
            subject = load(setup.name, setup.answer_timeout, setup.source)
            if subject.innermost.native is not None and setup.memory is None:
                limit_memory(address_space() + NATIVE_MEMORY)
        except InputError as error:
            reason = str(error)
            if setup.memory is not None and "memory" not in reason:
                reason = f"memory {setup.memory} MB is probably too small: {reason}"
            self._send(Refusal(reason))
            return
        self._intact()
        signal.signal(signal.SIGTERM, lambda *_: _leave(subject))
        if setup.output not in ("", os.devnull):
            # An explorer that has left itself no descriptors has no output.
            with suppress(OSError):
                _print_to(setup.output)
        native = subject.innermost.native
        if native is not None:
            native.library.print_line_by_line()
        has_shield = isinstance(subject.explore, Shield)
        self._send(ExplorerDescription(subject.keywords, _digest(subject), has_shield))
        with subject.running():
            self._serve(subject, ExplorerRunner(subject.player(), self._beat, self._intact))

    def _serve(self, subject: Subject, runner: ExplorerRunner) -> None:
        while True:
            job = self._connection.recv()
            try:
                self._do(subject, runner, job)
                self._look()
            except OSError:
                raise
            except InputError as error:  # a bound without a value for some world
                self._send(Refusal(str(error)))
            except Exception:  # noqa: BLE001  # explorers' errors never get here: it is ours
                self._send(Failure(traceback.format_exc()))

    def _do(self, subject: Subject, runner: ExplorerRunner, job: Job) -> None:
        match job:
            case PlayRuns():
                self._world_player(runner).play_runs(job)
            case PlayRecords(records, policy, order):
                self._send(RecordLogs(runner.play_records(records, policy, order)))
            case PlayStretch():
                self._send(self._play_stretch(subject, job))
            case Trace():
                self._world_player(runner).trace(job)

    def _world_player(self, runner: ExplorerRunner) -> WorldPlayer:
        """The part that plays in worlds; the process that forked this one has loaded it."""
        from allworlds.engines.isolation.world_player import WorldPlayer

        if self._in_worlds is None:
            self._in_worlds = WorldPlayer(runner, self._send)
        return self._in_worlds

    def _play_stretch(self, subject: Subject, job: PlayStretch) -> StretchResult:
        from allworlds.engines.isolation.generator_player import GeneratorPlayer
        from allworlds.engines.isolation.library_player import LibraryPlayer

        if self._stretches is None:
            if subject.native is not None:
                self._stretches = LibraryPlayer(subject.native, self._beat)
            else:
                self._stretches = GeneratorPlayer(subject.player(), self._beat, self._intact)
        result = self._stretches.play(job)
        self._intact()
        return result

    def _send(self, message: Message) -> None:
        self._connection.send_bytes(write_message(message))

    def _intact(self) -> None:
        """Leave if the explorer has forked this process; at intervals check pipe and timers."""
        if os.getpid() != self._pid:
            # The original goes on with the work; its copy must not do it a second time.
            os._exit(0)
        if time.monotonic() > self._look_at:
            self._look()

    def _look(self) -> None:
        """Leave if the explorer has closed this process's pipe; stop its timers."""
        for timer in TIMERS:
            signal.setitimer(timer, 0)
        os.fstat(self._connection.fileno())  # an OSError ends the process, see its role
        self._look_at = time.monotonic() + LOOK


def _print_to(path: str) -> None:
    """Redirect all later prints to that path."""
    descriptor = os.open(path, os.O_WRONLY | os.O_APPEND)
    os.dup2(descriptor, 1)
    os.dup2(descriptor, 2)
    os.close(descriptor)


def _digest(subject: Subject) -> str:
    """The SHA-256 of the explorer's file, or of the program's; empty if there is none."""
    subject = subject.innermost
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
    """End the user's program behind the explorer, and this process."""
    program = subject.innermost.program
    if program:
        program.close()
    os._exit(0)
