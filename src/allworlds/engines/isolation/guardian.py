"""The process that starts all others, and that ends them when its owner is gone.

It holds nothing but imported modules: no world, no foreign code.  Its children are therefore
clean, and start in milliseconds.  It is the reaper of its descendants: a process that an explorer
leaves behind, in whatever session, becomes its child when its own parent is gone, and is killed.
When its owner ends, however it ends, the socket between them is closed, and everything is killed.

Source: prctl(2), PR_SET_CHILD_SUBREAPER and PR_SET_PDEATHSIG.  Where they do not exist (macOS)
only the groups of its own children can be ended.
"""

from __future__ import annotations

import ctypes
import gc
import os
import pickle
import signal
import socket
import struct
import sys
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from selectors import EVENT_READ, DefaultSelector
from typing import Any, NoReturn

Role = Callable[[list[int]], None]
"""The main function of a forked process.

It is called with the descriptors that the process was given, but for the first, which becomes its
stderr and stdout; and behind them, in a role of :data:`OWNERS`, a socket to the guardian."""

OWNERS = frozenset({"referee"})
"""The roles that may own processes; no foreign code is in them."""

LOOK = 1.0
"""Seconds after which the guardian looks again whether its owner is there."""

_SUBREAPER, _DEATH_SIGNAL = 36, 1
_LENGTH = struct.Struct("<I")
_MOST_DESCRIPTORS = 4


@dataclass(frozen=True, slots=True)
class Spawn:
    """Fork a process for a role.

    Attributes:
        role: the name of the role.
        directory, path, environment: of the process.
    """

    role: str
    directory: str
    path: list[str]
    environment: dict[str, str]


@dataclass(frozen=True, slots=True)
class EndProcesses:
    """Kill processes with all that they have started; answered when they have ended."""

    pids: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class AskExitCode:
    """Ask for the exit code of a process."""

    pid: int


@dataclass(frozen=True, slots=True)
class Prepare:
    """Call a function without arguments: all that are forked later share the modules it loads.

    Attributes:
        module, function: its module, which is one of ours, and its name.
    """

    module: str
    function: str


Request = Spawn | EndProcesses | AskExitCode | Prepare
Answer = int | None
"""A process's number to :class:`Spawn`; to :class:`AskExitCode` its exit code (minus the signal),
or None while it goes on."""


def send(sock: socket.socket, message: object, descriptors: list[int]) -> None:
    """Send a message, with descriptors that the other side gets as its own."""
    text = pickle.dumps(message)
    socket.send_fds(sock, [_LENGTH.pack(len(text))], descriptors)
    sock.sendall(text)


def receive(sock: socket.socket) -> tuple[Any, list[int]]:
    """The next message with its descriptors.

    Raises:
        EOFError: if the other side has gone.
    """
    try:
        head, descriptors, _, _ = socket.recv_fds(sock, _LENGTH.size, _MOST_DESCRIPTORS)
        while 0 < len(head) < _LENGTH.size:
            head += _some(sock, _LENGTH.size - len(head))
        if not head:
            raise EOFError
        left = _LENGTH.unpack(head)[0]
        parts = []
        while left:
            parts.append(_some(sock, left))
            left -= len(parts[-1])
    except ConnectionError:
        raise EOFError from None
    return pickle.loads(b"".join(parts)), [*descriptors]  # noqa: S301  # our own process


def _some(sock: socket.socket, most: int) -> bytes:
    part = sock.recv(min(most, 1 << 16))
    if not part:
        raise EOFError
    return part


class _Guardian:
    """The guardian: it serves its owner, and the owners among its processes."""

    def __init__(self, owner: socket.socket, roles: dict[str, Role]) -> None:
        self._roles = roles
        self._selector = DefaultSelector()
        self._selector.register(owner, EVENT_READ)
        self._owner = owner
        self._parent = os.getppid()
        self._known: set[int] = set()
        # A process is owned by the one that asked for it, and does not outlive it.
        self._owned: dict[socket.socket, set[int]] = {owner: set()}
        self._control: dict[int, socket.socket] = {}
        self._ended: dict[int, int] = {}
        self._prepared: set[Prepare] = set()

    def run(self) -> NoReturn:
        """Serve until the owner is gone; then end everything."""
        _control(_SUBREAPER)
        # Imported modules stay: no forked process looks for garbage there.
        gc.freeze()
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        for terminating in (signal.SIGTERM, signal.SIGHUP):
            signal.signal(terminating, lambda *_: self._end_all())
        with suppress(EOFError):
            while os.getppid() == self._parent:
                for key, _ in self._selector.select(LOOK):
                    assert isinstance(key.fileobj, socket.socket)
                    # One that was ended by a request heard just before is heard no more.
                    if key.fileobj in self._owned:
                        self._serve(key.fileobj)
                self._reap()
        self._end_all()

    def _end_all(self) -> NoReturn:
        kill_tree(os.getpid(), itself=False)
        os._exit(0)

    def _serve(self, sock: socket.socket) -> None:
        try:
            request, descriptors = receive(sock)
        except EOFError:
            if sock is self._owner:
                raise
            self._end(tuple(self._owned[sock]))
            self._forget(sock)
            return
        with suppress(BrokenPipeError, ConnectionResetError):
            send(sock, self._answer(sock, request, descriptors), [])

    def _forget(self, sock: socket.socket) -> None:
        self._selector.unregister(sock)
        del self._owned[sock]
        self._control = {pid: kept for pid, kept in self._control.items() if kept is not sock}
        sock.close()

    def _answer(self, sock: socket.socket, request: Request, descriptors: list[int]) -> Answer:
        match request:
            case Spawn():
                pid = self._spawn(request, descriptors)
                self._owned[sock].add(pid)
                return pid
            case EndProcesses(pids):
                self._end(pids)
                return None
            case AskExitCode(pid):
                self._reap()
                return self._ended.get(pid)
            case Prepare():
                self._prepare(request)
                return None

    def _prepare(self, request: Prepare) -> None:
        if request not in self._prepared:
            getattr(import_module(request.module), request.function)()
            self._prepared.add(request)
            gc.freeze()

    def _spawn(self, request: Spawn, descriptors: list[int]) -> int:
        ours, theirs = socket.socketpair()
        owns = request.role in OWNERS
        pid = os.fork()
        if pid == 0:
            self._child(request, [*descriptors, *([theirs.detach()] if owns else [])])
        for descriptor in descriptors:
            os.close(descriptor)
        theirs.close()
        self._known.add(pid)
        if owns:
            self._control[pid] = ours
            self._owned[ours] = set()
            self._selector.register(ours, EVENT_READ)
        else:
            ours.close()
        return pid

    def _child(self, request: Spawn, descriptors: list[int]) -> NoReturn:
        """Run the role in this process, and end it, whatever happens."""
        code = 1
        try:
            guardian = os.getppid()
            os.setsid()
            _control(_DEATH_SIGNAL, signal.SIGKILL)
            if os.getppid() != guardian:
                os._exit(1)
            _keep_only(descriptors)
            for terminating in (signal.SIGTERM, signal.SIGHUP):
                signal.signal(terminating, signal.SIG_DFL)
            os.chdir(request.directory)
            sys.path[:] = request.path
            os.environ.clear()
            os.environ.update(request.environment)
            _forget_randomness()
            os.dup2(descriptors[0], 2)
            os.dup2(descriptors[0], 1)
            self._roles[request.role](descriptors[1:])
            code = 0
        finally:
            os._exit(code)

    def _end(self, pids: tuple[int, ...]) -> None:
        family, waiting = list(pids), list(pids)
        while waiting:
            control = self._control.get(waiting.pop())
            below = self._owned.get(control, set()) if control else set()
            family += below
            waiting += below
        for pid in self._known.intersection(family) - self._ended.keys():
            kill_tree(pid)
            with suppress(ChildProcessError):
                os.waitpid(pid, 0)
        # A process that they have left in a session of its own is a child of ours by now.
        for stray in _children().get(os.getpid(), ()):
            if stray not in self._known:
                kill_tree(stray)
        self._reap()
        for pid in family:
            self._known.discard(pid)
            self._ended.pop(pid, None)
            if pid in self._control:
                self._forget(self._control[pid])
        for owned in self._owned.values():
            owned.difference_update(family)

    def _reap(self) -> None:
        with suppress(ChildProcessError):
            while True:
                pid, status = os.waitpid(-1, os.WNOHANG)
                if not pid:
                    return
                if pid in self._known:
                    self._ended[pid] = os.waitstatus_to_exitcode(status)


def serve(owner: socket.socket, roles: dict[str, Role]) -> NoReturn:
    """Be a guardian until the owner is gone."""
    _Guardian(owner, roles).run()


def _keep_only(descriptors: list[int]) -> None:
    """Close everything but the standard streams and these."""
    kept = sorted({0, 1, 2, *descriptors})
    for low, high in zip(kept, [*kept[1:], 1 << 16], strict=True):
        os.closerange(low + 1, high)


def _forget_randomness() -> None:
    """Draw other random numbers than the siblings of this process."""
    import random

    random.seed()


def _control(option: int, value: int = 1) -> None:
    """Call prctl, where there is one."""
    if sys.platform == "linux":
        ctypes.CDLL(None, use_errno=True).prctl(option, int(value), 0, 0, 0)


def _children() -> dict[int, list[int]]:
    """The children of every process, read from /proc; empty where there is none."""
    found: dict[int, list[int]] = {}
    with suppress(FileNotFoundError):
        # A process may end while it is looked at, so that nothing but its own entry is asked for.
        for name in filter(str.isdigit, os.listdir("/proc")):  # noqa: PTH208
            with suppress(OSError, ValueError, IndexError):
                # The name in parentheses may hold anything, parentheses and blanks included.
                text = Path("/proc", name, "stat").read_text(errors="replace")
                fields = text.rpartition(")")[2].split()
                if fields[0] != "Z":
                    found.setdefault(int(fields[1]), []).append(int(name))
    return found


def kill_tree(pid: int, *, itself: bool = True) -> None:
    """End a process's descendants, whatever sessions they are in, and the process itself.

    It is stopped first, and its descendants are looked for until there are none, so that none
    of them can start another one unseen.
    """
    if itself:
        _signal(pid, signal.SIGSTOP)
    while True:
        family, waiting = [], [pid]
        children = _children()
        while waiting:
            below = children.get(waiting.pop(), [])
            family += below
            waiting += below
        if not family:
            break
        for member in family:
            _signal(member, signal.SIGSTOP)
        for member in family:
            _signal(member, signal.SIGKILL)
    if itself:
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(pid, signal.SIGKILL)
        _signal(pid, signal.SIGKILL)


def _signal(pid: int, number: int) -> None:
    with suppress(ProcessLookupError, PermissionError):
        os.kill(pid, number)
