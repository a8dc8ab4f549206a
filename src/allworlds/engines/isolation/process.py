"""The owner's side: starting processes through the guardian, hearing them, ending them."""

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
    ASKING,
    Ask,
    EndProcesses,
    Prepare,
    Request,
    Spawn,
    receive,
    send,
)
from allworlds.engines.isolation.jobs import HarnessError
from allworlds.engines.isolation.messages import read
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
its player notices itself, and for a process that has still something to be heard."""


ANSWERS = 120.0
"""Seconds in which a guardian that is alive answers, however busy the machine."""

STALL = 10
"""Seconds in which a player that has begun to say something must go on with it."""


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
        """How a process has ended; None while it goes on."""
        return self._ask(Ask(pid), [])

    def prepare(self, module: str, function: str) -> None:
        """Have it call one of our functions, so that all later processes share what that loads."""
        self._ask(Prepare(module, function), [])

    def close(self) -> None:
        """Let it go, which ends everything that it has started."""
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


def started(hash_seed: int) -> Guardian:
    """A guardian of its own interpreter.

    Args:
        hash_seed: of the interpreter.  All that it forks have the same, so that an explorer
            that depends on the order of a set does the same in each; another one tells.
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
    """The guardian of this process with that seed; it is started once."""
    key = (os.getpid(), hash_seed)
    if key not in _guardians:
        _guardians[key] = started(hash_seed)
        atexit.register(forget, _guardians[key])
    return _guardians[key]


def forget(lost: Guardian) -> None:
    """Start another guardian next time."""
    for key in [key for key, kept in _guardians.items() if kept is lost]:
        del _guardians[key]
    lost.close()


def child_path() -> list[str]:
    """Where a child looks for modules: what is the user's comes last, and hides nothing of ours."""
    users = {"", str(Path.cwd())}
    main = getattr(sys.modules.get("__main__"), "__file__", None)
    if main:
        users.add(str(Path(main).resolve().parent))
    ours = [entry for entry in sys.path if entry not in users]
    return [*ours, *(entry for entry in sys.path if entry in users and entry)]


class Garbled(EOFError):
    """What was said is no message, and nothing more can be heard."""


class Process:
    """A child with its pipe and the memory in which its heart beats.

    Args:
        guardian: starts it.
        role: what it does.
        setup: its first message.
    """

    def __init__(self, guardian: Guardian, role: str, setup: object) -> None:
        self._guardian = guardian
        self._foreign = role not in ASKING
        self.connection, theirs = Pipe()
        if self._foreign:
            _let_stall(self.connection)
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
        """Hand over a message; what has ended does not hear it, and will be noticed."""
        with suppress(OSError):
            self.connection.send(message)

    def receive(self) -> Any:
        """The next message; waits for it.

        Raises:
            EOFError: if the process has ended.
            Garbled: if it has said what is no message: a player's pipe is open to foreign code.
            InputError: if it was given something that cannot be done.
            HarnessError: if the process itself has failed.
        """
        try:
            message = self._hear()
        except OSError:
            raise EOFError from None
        except ValueError as error:
            raise Garbled(str(error)) from None
        if isinstance(message, InputError | HarnessError):
            raise message
        return message

    def _hear(self) -> Any:
        return read(self.connection.recv_bytes()) if self._foreign else self.connection.recv()

    def silent_for(self) -> float:
        """Seconds since its heart has beaten, or since it has nothing to beat for."""
        now, seen = time.monotonic(), (self.beat[0], self.beat[1])
        if seen[1] == 0 or seen != self._seen:
            self._seen, self._since = seen, now
        return now - self._since

    def has_ended(self) -> bool:
        """The process is no more, and all that it has said has been heard.

        The pipe alone does not tell: a process forked by an explorer may hold it open.
        """
        return not self.connection.poll() and self._guardian.exit_code(self.pid) is not None

    def death(self) -> tuple[str, bool]:
        """How the process ended, as a sentence; and whether it may be the machine's doing."""
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


def _let_stall(connection: Connection) -> None:
    """See to it that who reads there is not kept waiting for the rest of a message for ever.

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
    """MB of address space that this process has; 0 where that cannot be known."""
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
