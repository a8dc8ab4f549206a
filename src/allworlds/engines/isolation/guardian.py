"""The process that starts all others, and that ends them when its owner is gone.

The guardian holds imported modules only: no world, no user's code.  Its children are therefore
clean, and start in milliseconds.  All of them share its addresses and its hash seed; so a player
that is to have others is forked by a **nursery**: another guardian, which this one starts when it
is asked for, in an interpreter of its own.

The guardian is the reaper of its descendants: a process that an explorer leaves behind, in any
session, becomes its child when its own parent is gone, and is killed.  When its owner ends, however
it ends, the socket between them is closed, and everything is killed.  A child that is stopped, by
an explorer perhaps, goes on at once.

The stderr of its processes goes through it (:mod:`allworlds.engines.isolation.relay`).
"""

from __future__ import annotations

import gc
import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from selectors import EVENT_READ, DefaultSelector
from typing import NoReturn

from allworlds.engines.isolation.guardian_requests import (
    Answer,
    AskExitCode,
    EndProcesses,
    Prepare,
    ReachNursery,
    ServeAnother,
    Spawn,
    receive,
    send,
)
from allworlds.engines.isolation.process_tree import (
    DEATH_SIGNAL,
    SUBREAPER,
    children_by_parent,
    control,
    kill_tree,
)
from allworlds.engines.isolation.relay import Relay
from allworlds.explorers import HASH_SEED

Role = Callable[[list[int]], None]
"""The main function of a forked process.

It is called with the descriptors that the process was given, without the first, which is stderr and
stdout by then.  In a role of :data:`OWNERS` a socket to the guardian follows."""

OWNERS = frozenset({"referee"})
"""The roles that may own processes; no user's code is in them."""

ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1"}
"""The environment in which NumPy is loaded: its threads for linear algebra are not needed, and
take a tenth of a second at their start.  Players have the owner's environment."""

GUARDIAN, NURSERY = "guardian", "nursery"
"""The kinds of processes that fork others."""

LOOK = 1.0
"""Seconds after which the guardian looks again whether its owner is there."""

MOST_REAPED = 64
"""The number of children that are looked at in one go: some may be stopped again and again."""

_START = """import json, sys
sys.path[:] = json.loads(sys.argv[1])
from allworlds.engines.isolation.roles import guard
guard(int(sys.argv[2]), sys.argv[3])"""
"""The script of a guardian."""


def launch(
    kind: str, hash_seed: int, path: list[str]
) -> tuple[socket.socket, subprocess.Popen[bytes]]:
    """A guardian in an interpreter of its own, and the socket to it.

    Args:
        kind: :data:`GUARDIAN` or :data:`NURSERY`; shown on its command line.
        hash_seed: of the interpreter.
        path: from which it imports.
    """
    ours, theirs = socket.socketpair()
    process = subprocess.Popen(  # noqa: S603  # our own module
        [sys.executable, "-P", "-c", _START, json.dumps(path), str(theirs.fileno()), kind],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        pass_fds=(theirs.fileno(),),
        # A Ctrl-C is for the owner.
        start_new_session=True,
        env={**ONE_THREAD, **os.environ, HASH_SEED: str(hash_seed)},
    )
    theirs.close()
    return ours, process


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
        self._nurseries: dict[ReachNursery, tuple[socket.socket, int]] = {}
        self._relay = Relay()
        self._selector.register(self._relay, EVENT_READ)

    def run(self) -> NoReturn:
        """Serve until the owner is gone; then end everything."""
        control(SUBREAPER)
        # Imported modules stay: no forked process looks for garbage there.
        gc.freeze()
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        for terminating in (signal.SIGTERM, signal.SIGHUP):
            signal.signal(terminating, lambda *_: self._end_all())
        # The end or the stop of a child ends the waiting.
        signalled, signals = socket.socketpair()
        self._selector.register(signalled, EVENT_READ)
        for one in (signalled, signals):
            one.setblocking(False)  # noqa: FBT003  # it takes no keyword
        signal.signal(signal.SIGCHLD, lambda *_: None)
        signal.set_wakeup_fd(signals.fileno(), warn_on_full_buffer=False)
        with suppress(EOFError):
            while os.getppid() == self._parent:
                for key, _ in self._selector.select(LOOK):
                    if key.fileobj is self._relay:
                        self._relay.pass_on()
                        continue
                    if key.fileobj is signalled:
                        signalled.recv(1 << 12)
                        continue
                    assert isinstance(key.fileobj, socket.socket)
                    # One that was ended by a request heard just before is heard no more.
                    if key.fileobj in self._owned:
                        self._serve(key.fileobj)
                self._reap()
        self._end_all()

    def _end_all(self) -> NoReturn:
        kill_tree(os.getpid(), itself=False)
        self._relay.pass_on()
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
        if isinstance(request, ServeAnother):
            self._serve_another(*descriptors)
            return
        with suppress(BrokenPipeError, ConnectionResetError):
            if isinstance(request, ReachNursery):
                pid, way = self._reach(request)
                with way:
                    send(sock, pid, [way.fileno()])
                return
            send(sock, self._answer(sock, request, descriptors), [])

    def _serve_another(self, descriptor: int) -> None:
        owner = socket.socket(fileno=descriptor)
        self._owned[owner] = set()
        self._selector.register(owner, EVENT_READ)

    def _reach(self, request: ReachNursery) -> tuple[int, socket.socket]:
        """The number of a nursery, and a socket to it.

        The nursery reads the messages there as soon as it is ready.
        """
        self._reap()
        if request not in self._nurseries or self._nurseries[request][1] in self._ended:
            ours, nursery = launch(NURSERY, request.seed, sys.path)
            nursery.returncode = 0  # it is reaped here
            self._known.add(nursery.pid)
            self._nurseries[request] = ours, nursery.pid
        ours, pid = self._nurseries[request]
        theirs, way = socket.socketpair()
        with theirs, suppress(BrokenPipeError, ConnectionResetError):
            send(ours, ServeAnother(), [theirs.fileno()])
        return pid, way

    def _forget(self, sock: socket.socket) -> None:
        self._selector.unregister(sock)
        del self._owned[sock]
        self._control = {pid: kept for pid, kept in self._control.items() if kept is not sock}
        sock.close()

    def _answer(
        self,
        sock: socket.socket,
        request: Spawn | EndProcesses | AskExitCode | Prepare,
        descriptors: list[int],
    ) -> Answer:
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
                return self._prepare(request)

    def _prepare(self, request: Prepare) -> Answer:
        if request in self._prepared:
            return None
        returned: Answer = getattr(import_module(request.module), request.function)()
        if returned is None:
            self._prepared.add(request)
        gc.freeze()
        return returned

    def _spawn(self, request: Spawn, descriptors: list[int]) -> int:
        ours, theirs = socket.socketpair()
        owns = request.role in OWNERS
        if not request.relayed:
            descriptors[0] = self._relay.leading_to(descriptors[0])
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
        """Run the role in this process, and end the process in every case."""
        code = 1
        try:
            guardian = os.getppid()
            signal.set_wakeup_fd(-1)
            os.setsid()
            control(DEATH_SIGNAL, signal.SIGKILL)
            if os.getppid() != guardian:
                os._exit(1)
            _keep_only(descriptors)
            for handled in (signal.SIGTERM, signal.SIGHUP, signal.SIGCHLD):
                signal.signal(handled, signal.SIG_DFL)
            os.chdir(request.directory)
            sys.path[:] = request.path
            os.environ.clear()
            os.environ.update(request.environment)
            _forget_randomness()
            os.dup2(descriptors[0], 2)
            os.dup2(descriptors[0], 1)
            os.close(descriptors[0])
            self._roles[request.role](descriptors[1:])
            code = 0
        finally:
            os._exit(code)

    def _end(self, pids: tuple[int, ...]) -> None:
        family, waiting = list(pids), list(pids)
        while waiting:
            to_owner = self._control.get(waiting.pop())
            below = self._owned.get(to_owner, set()) if to_owner else set()
            family += below
            waiting += below
        for pid in self._known.intersection(family) - self._ended.keys():
            kill_tree(pid)
            with suppress(ChildProcessError):
                os.waitpid(pid, 0)
        # A process that they have left in a session of its own is a child of ours by now.
        for stray in children_by_parent().get(os.getpid(), ()):
            if stray not in self._known:
                kill_tree(stray)
        self._reap()
        self._relay.pass_on()
        for pid in family:
            self._known.discard(pid)
            self._ended.pop(pid, None)
            if pid in self._control:
                self._forget(self._control[pid])
        for owned in self._owned.values():
            owned.difference_update(family)

    def _reap(self) -> None:
        """Take note of children that have ended, and let those go on that were stopped."""
        with suppress(ChildProcessError):
            for _ in range(MOST_REAPED):
                pid, status = os.waitpid(-1, os.WNOHANG | os.WUNTRACED)
                if not pid:
                    return
                if pid in self._known:
                    self._heed(pid, status)

    def _heed(self, pid: int, status: int) -> None:
        if os.WIFSTOPPED(status):
            os.kill(pid, signal.SIGCONT)
        else:
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
