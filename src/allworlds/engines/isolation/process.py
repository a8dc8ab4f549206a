"""The owner's side of processes: they are started and ended through the guardian, and read."""

from __future__ import annotations

import atexit
import json
import mmap
import os
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import suppress
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from allworlds.engines.isolation.guardian import (
    OWNERS,
    AskExitCode,
    EndProcesses,
    Prepare,
    Request,
    Spawn,
    receive,
    send,
)
from allworlds.engines.isolation.jobs import HarnessError
from allworlds.engines.isolation.messages import Failure, Refusal, read_message
from allworlds.inputs import InputError

_START = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); "
    "from allworlds.engines.isolation.roles import guard; guard(int(sys.argv[2]))"
)

BEAT_WORDS = 2
"""The shared memory: the number of the current run, and the turns of the explorer in it."""

NO_RUN = (1 << 64) - 1
"""The number of the current run before the first."""

GRACE = 2.0
"""Seconds more where the owner is not the first to know: for a foreign program, whose silence
its player notices itself, and for a process that has sent a message before."""

ANSWERS = 120.0
"""Seconds in which a guardian that is alive answers, however busy the machine."""

STALL = 10
"""Seconds in which a player that has begun to send a message must go on with it."""


class Guardian:
    """The owner's side of a guardian.

    Raises:
        HarnessError: where there is none: it has been killed or stopped, or could not be started.
    """

    def __init__(self, sock: socket.socket, process: subprocess.Popen[bytes] | None = None) -> None:
        sock.settimeout(ANSWERS)
        self._sock, self._process = sock, process
        self._turn = threading.Lock()

    def spawn(self, role: str, descriptors: list[int]) -> int:
        """The number of a new process that has copies of these descriptors."""
        with suppress(OSError):
            sys.stderr.flush()
        request = Spawn(role, str(Path.cwd()), child_path(), dict(os.environ))
        pid = self._ask(request, [2, *descriptors])
        assert pid is not None
        return pid

    def end(self, *pids: int) -> None:
        """Kill these processes and everything that they have started."""
        self._ask(EndProcesses(pids), [])

    def exit_code(self, pid: int) -> int | None:
        """The exit code of a process; None while it goes on."""
        return self._ask(AskExitCode(pid), [])

    def prepare(self, module: str, function: str) -> None:
        """Have it call a function of ours: all later processes share the modules that it loads."""
        self._ask(Prepare(module, function), [])

    def close(self) -> None:
        """End it, and with it everything that it has started."""
        self._sock.close()
        if self._process:
            try:
                self._process.wait(ANSWERS)
            except subprocess.TimeoutExpired:  # it has been stopped
                self._process.kill()
                self._process.wait()

    def _ask(self, request: Request, descriptors: list[int]) -> int | None:
        with self._turn:
            try:
                send(self._sock, request, descriptors)
                answer: int | None = receive(self._sock)[0]
            except (EOFError, OSError) as error:
                forget(self)
                raise HarnessError(f"the guardian of the processes has gone: {error}") from None
        return answer


def start_guardian(hash_seed: int) -> Guardian:
    """A guardian of its own interpreter.

    Args:
        hash_seed: of the interpreter.  All that it forks have the same, so that an explorer
            that depends on the order of a set does the same in each; another seed tells.
    """
    path = json.dumps(child_path())
    ours, theirs = socket.socketpair()
    environment = {**os.environ, "PYTHONHASHSEED": str(hash_seed)}
    process = subprocess.Popen(  # noqa: S603  # our own module
        [sys.executable, "-P", "-c", _START, path, str(theirs.fileno())],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        pass_fds=(theirs.fileno(),),
        # A Ctrl-C is for the owner.
        start_new_session=True,
        env=environment,
    )
    theirs.close()
    return Guardian(ours, process)


_guardians: dict[tuple[int, int], Guardian] = {}


def guardian(hash_seed: int = 0) -> Guardian:
    """This process's guardian with that seed; it is started once."""
    key = (os.getpid(), hash_seed)
    if key not in _guardians:
        _guardians[key] = start_guardian(hash_seed)
        atexit.register(forget, _guardians[key])
    return _guardians[key]


def forget(lost: Guardian) -> None:
    """Start another guardian next time."""
    for key in [key for key, kept in _guardians.items() if kept is lost]:
        del _guardians[key]
    lost.close()


def child_path() -> list[str]:
    """A child's import path: the user's folders come last, and hide no module of ours."""
    users = {"", str(Path.cwd())}
    main = getattr(sys.modules.get("__main__"), "__file__", None)
    if main:
        users.add(str(Path(main).resolve().parent))
    ours = [entry for entry in sys.path if entry not in users]
    return [*ours, *(entry for entry in sys.path if entry in users and entry)]


class Garbled(EOFError):
    """Bytes that are no message, behind which nothing more can be read."""


class Process:
    """A child with its pipe and the memory of its heartbeat.

    Args:
        guardian: starts it.
        role: what it does.
        setup: its first message.
    """

    def __init__(self, guardian: Guardian, role: str, setup: object) -> None:
        self._guardian = guardian
        self._foreign = role not in OWNERS
        self.connection, theirs = Pipe()
        if self._foreign:
            _set_read_timeout(self.connection)
        with tempfile.TemporaryFile() as memory:
            memory.truncate(8 * BEAT_WORDS)
            self._memory = mmap.mmap(memory.fileno(), 8 * BEAT_WORDS)
            self.beat = memoryview(self._memory).cast("Q")
            self.beat[0] = NO_RUN
            try:
                self.pid = guardian.spawn(role, [theirs.fileno(), memory.fileno()])
            finally:
                theirs.close()
        self._seen: tuple[int, int] = (0, 0)
        self._since = time.monotonic()
        self.send(setup)

    def send(self, message: object) -> None:
        """Send a message; that a process has ended is noticed elsewhere."""
        with suppress(OSError):
            self.connection.send(message)

    def receive(self) -> Any:
        """Wait for the next message.

        Raises:
            EOFError: if the process has ended.
            Garbled: if its bytes are no message: a player's pipe is open to foreign code.
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
        if self._foreign:
            return read_message(self.connection.recv_bytes())
        return self.connection.recv()

    def silent_for(self) -> float:
        """Seconds since its heartbeat has changed, or since it has nothing to do."""
        now, seen = time.monotonic(), (self.beat[0], self.beat[1])
        if seen[1] == 0 or seen != self._seen:
            self._seen, self._since = seen, now
        return now - self._since

    def has_ended(self) -> bool:
        """The process has ended, and all its messages have been received.

        The pipe alone does not tell: a process forked by an explorer may hold it open.
        """
        return not self.connection.poll() and self._guardian.exit_code(self.pid) is not None

    def death(self) -> tuple[str, bool]:
        """The end of the process in words; and whether it may be the machine's doing."""
        deadline = time.monotonic() + GRACE
        while (code := self._guardian.exit_code(self.pid)) is None:
            if time.monotonic() > deadline:
                return "the end of the interpreter's pipe", False
            time.sleep(0.01)
        how = f"exit code {code}" if code >= 0 else f"signal {-code}"
        return f"the end of the interpreter ({how})", code < 0

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
    """End processes of one guardian, and all that they have started."""
    if not processes:
        return
    with suppress(HarnessError):  # without a guardian there are no processes either
        processes[0]._guardian.end(*(process.pid for process in processes))  # noqa: SLF001
    for process in processes:
        process.connection.close()
        process.beat.release()
        process._memory.close()  # noqa: SLF001


def address_space() -> int:
    """MB of address space of this process; 0 where that cannot be known."""
    with suppress(OSError):
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        return pages * mmap.PAGESIZE >> 20
    return 0


def limit_memory(megabytes: int) -> None:
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
        raise InputError(
            f"memory {megabytes} MB is probably too small: a process is larger before it begins"
        ) from None
