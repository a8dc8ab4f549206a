"""The owner's side of processes: their start and end through the guardian, and their messages."""

from __future__ import annotations

import atexit
import mmap
import os
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from contextlib import suppress
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any

from allworlds.engines.isolation.failures import GuardianLost, HarnessError
from allworlds.engines.isolation.guardian import GUARDIAN, OWNERS, launch
from allworlds.engines.isolation.guardian_requests import (
    AskExitCode,
    EndProcesses,
    Prepare,
    ReachNursery,
    Request,
    Spawn,
    receive,
    send,
)
from allworlds.engines.isolation.messages import Failure, Refusal, read_message
from allworlds.engines.isolation.process_tree import (
    Stops,
    children_by_parent,
    kill_tree,
    let_go_on,
)
from allworlds.explorers import HASH_SEED
from allworlds.inputs import InputError
from allworlds.words import ended_by

BEAT_WORDS = 2
"""The shared memory: the number of the current run, and the turns of the explorer in it."""

NO_RUN = (1 << 64) - 1
"""The number of the current run before the first."""

GRACE = 2.0
"""Extra seconds where the owner is not the first to notice: for a user's program, whose silence
its player notices itself, and for a process that has sent a message before."""

LAST_WORDS = 2.0
"""Seconds in which the exit code of a process is known after the end of its pipe."""

ANSWERS = 120.0
"""Seconds in which a guardian that is alive answers, however busy the machine."""

WAKE = 1.0
"""Seconds of silence after which a referee and its guardian are woken: they may be stopped."""

LOOK = 0.05
"""Seconds between two looks at a guardian that does not answer."""

STALL = 10
"""Seconds in which a player that has begun to send a message must go on with it."""

LONGEST = 1 << 28
"""Bytes of the longest message of a player; whatever announces more is noise."""


class Guardian:
    """The owner's side of a guardian, or of a nursery.

    Args:
        sock: to it.
        pid: its number.
        process: of the guardian, if its owner has started it.

    Raises:
        GuardianLost: if it has been killed or stopped, or could not be started.
    """

    def __init__(
        self, sock: socket.socket, pid: int, process: subprocess.Popen[bytes] | None = None
    ) -> None:
        sock.settimeout(ANSWERS)
        self._sock, self._pid, self._process = sock, pid, process
        self._turn = threading.Lock()
        self._nurseries: dict[int, Guardian] = {}

    def spawn(self, role: str, descriptors: list[int], hash_seed: int = 0) -> int:
        """The number of a new process that has copies of these descriptors.

        Programs that the process starts have the given hash seed; the process has the guardian's.
        """
        with suppress(OSError):
            sys.stderr.flush()
        environment = {**os.environ, HASH_SEED: str(hash_seed)}
        relayed = os.getpid() in _relayed
        request = Spawn(role, str(Path.cwd()), child_path(), environment, relayed)
        pid, _ = self._ask(request, [2, *descriptors])
        assert pid is not None
        return pid

    def end(self, *pids: int) -> None:
        """Kill these processes and everything that they have started."""
        self._ask(EndProcesses(pids))

    def exit_code(self, pid: int) -> int | None:
        """The exit code of a process; None while it goes on."""
        return self._ask(AskExitCode(pid))[0]

    def prepare(self, module: str, function: str) -> int | None:
        """Let it call a function of this package: all later processes share the loaded modules.

        Return what the function has returned, a number or None.
        """
        return self._ask(Prepare(module, function))[0]

    def nursery(self, seed: int) -> Guardian:
        """A guardian that forks processes with this hash seed, and addresses of their own.

        It starts at the first call, which does not wait for it.
        """
        if seed not in self._nurseries:
            pid, descriptors = self._ask(ReachNursery(seed))
            assert pid is not None
            way = socket.socket(fileno=descriptors[0])
            self._nurseries[seed] = Guardian(way, pid)
        return self._nurseries[seed]

    def wake(self) -> None:
        """Let the process go on, if it was stopped."""
        let_go_on(self._pid)

    def close(self) -> None:
        """End the guardian, and everything that it has started."""
        for nursery in self._nurseries.values():
            nursery.close()
        self._sock.close()
        if self._process:
            stops, deadline = Stops(), time.monotonic() + ANSWERS
            while not _ends(self._process, LOOK):
                if stops.too_many(self._pid) or time.monotonic() > deadline:
                    kill_tree(self._pid)
                self.wake()

    def _ask(
        self, request: Request, descriptors: Sequence[int] = ()
    ) -> tuple[int | None, list[int]]:
        with self._turn:
            try:
                send(self._sock, request, [*descriptors])
                self._await()
                answer: tuple[int | None, list[int]] = receive(self._sock)
            except (EOFError, OSError) as error:
                forget(self)
                silent = isinstance(error, TimeoutError)
                how = "does not answer" if silent else "was ended"
                raise GuardianLost(
                    f"the guardian of the processes {how}, perhaps because of the explorer"
                ) from None
            except BaseException:
                # An interrupt: part of a message may be under way, so no other can follow.
                forget(self)
                raise
        return answer

    def _await(self) -> None:
        """Wait until there is data to read, for at most the time-out of the socket."""
        stops, began = Stops(), time.monotonic()
        while not wait([self._sock], LOOK):
            waited = time.monotonic() - began
            if stops.too_many(self._pid) or waited > ANSWERS:
                raise TimeoutError
            self.wake()
            if waited > WAKE:
                # It cannot go on before a child that it starts, if that was stopped.
                for child in children_by_parent().get(self._pid, ()):
                    let_go_on(child)


def _ends(process: subprocess.Popen[bytes], seconds: float) -> bool:
    """Whether a process ends in so many seconds."""
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        return False
    return True


def start_guardian() -> Guardian:
    """A guardian of its own interpreter."""
    sock, process = launch(GUARDIAN, 0, child_path())
    return Guardian(sock, process.pid, process)


_guardians: dict[int, Guardian] = {}
_relayed: set[int] = set()


def have_relayed_stderr() -> None:
    """Note that the stderr of this process leads to a guardian."""
    _relayed.add(os.getpid())


def guardian() -> Guardian:
    """This process's guardian; it is started once."""
    pid = os.getpid()
    if pid not in _guardians:
        _guardians[pid] = start_guardian()
        atexit.register(forget, _guardians[pid])
    return _guardians[pid]


def forget(lost: Guardian) -> None:
    """Forget the guardian, so that the next use starts another one."""
    for key in [key for key, kept in _guardians.items() if kept is lost]:
        del _guardians[key]
    lost.close()


def child_path() -> list[str]:
    """A child's import path: the user's folders come last, and hide no module of the package."""
    users = {"", str(Path.cwd())}
    main = getattr(sys.modules.get("__main__"), "__file__", None)
    if main:
        users.add(str(Path(main).resolve().parent))
    ours = [entry for entry in sys.path if entry not in users]
    return [*ours, *(entry for entry in sys.path if entry in users and entry)]


class Garbled(EOFError):
    """Raised for bytes that are no message, after which no message can be read."""


class Process:
    """A child with its pipe and the memory of its heartbeat.

    Args:
        guardian: starts it.
        role: the name of its main function.
        setup: its first message.
        hash_seed: of programs that it starts.
    """

    def __init__(self, guardian: Guardian, role: str, setup: object, hash_seed: int = 0) -> None:
        self._guardian = guardian
        self._users = role not in OWNERS
        self.connection, theirs = Pipe()
        if self._users:
            _set_read_timeout(self.connection)
        with tempfile.TemporaryFile() as memory:
            memory.truncate(8 * BEAT_WORDS)
            self._memory = mmap.mmap(memory.fileno(), 8 * BEAT_WORDS)
            self.beat = memoryview(self._memory).cast("Q")
            self.beat[0] = NO_RUN
            try:
                self.pid = guardian.spawn(role, [theirs.fileno(), memory.fileno()], hash_seed)
            finally:
                theirs.close()
        self._seen: tuple[int, int] = (0, 0)
        self._since = time.monotonic()
        self.send(setup)

    def send(self, message: object) -> None:
        """Send a message; the end of the process is noticed elsewhere."""
        with suppress(OSError):
            self.connection.send(message)

    def receive(self) -> Any:
        """Wait for the next message.

        Raises:
            EOFError: if the process has ended.
            Garbled: if its bytes are no message: a player's pipe is open to the user's code.
            InputError: if its job cannot be done.
            HarnessError: if the process itself has failed.
        """
        try:
            message = self._read()
        except OSError:
            raise EOFError from None
        except ValueError as error:
            raise Garbled(str(error)) from None
        match message:
            case Refusal(text):
                raise InputError(text)
            case Failure(text):
                raise HarnessError(text)
            case InputError() | HarnessError():
                raise message
        return message

    def _read(self) -> Any:
        if not self._users:
            return self.connection.recv()
        try:
            return read_message(self.connection.recv_bytes(LONGEST))
        except OSError as error:
            if error.errno is None:  # the pipe is sound, the length is not
                raise Garbled("a message of an impossible length") from None
            raise

    def wake(self) -> None:
        """Let the process go on, if it was stopped."""
        let_go_on(self.pid)
        self._guardian.wake()

    def silent_for(self) -> float:
        """Seconds since its heartbeat has changed; 0 while idle, and before its first beat."""
        now, seen = time.monotonic(), (self.beat[0], self.beat[1])
        if seen[1] == 0 or seen != self._seen:
            self._seen, self._since = seen, now
        return now - self._since

    def has_ended(self) -> bool:
        """Whether the process has ended, and all its messages have been received.

        The pipe alone does not tell: a process forked by an explorer may hold it open.
        """
        return not self.connection.poll() and self._guardian.exit_code(self.pid) is not None

    def death(self) -> tuple[str, bool]:
        """The end of the process in words, and whether the machine may be the cause."""
        deadline = time.monotonic() + LAST_WORDS
        while (code := self._guardian.exit_code(self.pid)) is None:
            if time.monotonic() > deadline:
                return "the end of the process's pipe", False
            time.sleep(0.01)
        return f"the end of the process ({ended_by(code)})", code < 0

    def close(self) -> None:
        """End the process now, and all that it has started."""
        close_all(self)


def _set_read_timeout(connection: Connection) -> None:
    """Set a read timeout on the pipe, for a message that is begun and not ended.

    Source: socket(7), SO_RCVTIMEO.
    """
    with socket.socket(fileno=os.dup(connection.fileno())) as ours:
        ours.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, struct.pack("@ll", STALL, 0))


def close_all(*processes: Process) -> None:
    """End processes, and all that they have started."""
    by_guardian: dict[Guardian, list[int]] = {}
    for process in processes:
        by_guardian.setdefault(process._guardian, []).append(process.pid)  # noqa: SLF001
    for one, pids in by_guardian.items():
        with suppress(GuardianLost):  # without a guardian there are no processes either
            one.end(*pids)
    for process in processes:
        process.connection.close()
        process.beat.release()
        process._memory.close()  # noqa: SLF001
