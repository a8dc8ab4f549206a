"""The roles of forked processes, by name.

A guardian imports what each role needs, so that all its processes share it; a nursery, which forks
players alone, what a second player needs.
"""

from __future__ import annotations

import mmap
import os
import signal
import socket
import sys
from collections.abc import Callable, MutableSequence
from importlib import import_module
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING, NoReturn, TypeAlias, cast

from allworlds.engines.isolation.guardian import NURSERY, Role, serve
from allworlds.engines.isolation.player import PlayerProcess
from allworlds.engines.isolation.process import BEAT_WORDS, Guardian, have_relayed_stderr
from allworlds.engines.isolation.stderr_stream import patient_stderr

if TYPE_CHECKING:
    from allworlds.engines.isolation.referee import RefereeProcess


def player(connection: Connection, beat: MutableSequence[int], _: Guardian | None) -> PlayerProcess:
    """Run the process with the user's code in it."""
    return PlayerProcess(connection, beat)


def referee(
    connection: Connection, beat: MutableSequence[int], guardian: Guardian | None
) -> RefereeProcess:
    """Run the process that judges, which has no user's code in it."""
    from allworlds.engines.isolation.referee import RefereeProcess

    assert guardian is not None
    return RefereeProcess(connection, beat, guardian)


Maker: TypeAlias = Callable[
    [Connection, MutableSequence[int], Guardian | None], "PlayerProcess | RefereeProcess"
]


def _role(make: Maker) -> Role:
    """The main function of a process that has a pipe, shared memory, and perhaps a guardian."""

    def run(descriptors: list[int]) -> None:
        pipe, memory, *control = descriptors
        # Interrupts are the owner's business; and nothing an explorer prints may be lost in,
        # or get into, what the owner reads.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        sys.stdout = sys.stderr = patient_stderr()
        have_relayed_stderr()
        with mmap.mmap(memory, 8 * BEAT_WORDS) as shared, Connection(pipe) as connection:
            beat = memoryview(shared).cast("Q")
            guardian = Guardian(socket.socket(fileno=control[0]), os.getppid()) if control else None
            try:
                make(connection, cast("MutableSequence[int]", beat), guardian).run()
            except (EOFError, OSError):
                # The owner has gone, or the explorer has closed the pipe: there is nobody to
                # report to, and the owner sees the end of the pipe.
                os._exit(1)

    return run


ROLES: dict[str, Role] = {make.__name__: _role(make) for make in (player, referee)}
"""Every role by its name."""


def guard(descriptor: int, kind: str) -> NoReturn:
    """Be a guardian, or a nursery, with that end of the socket to the owner."""
    if kind != NURSERY:
        for module in ("referee", "world_player"):
            import_module(f"allworlds.engines.isolation.{module}")
    serve(socket.socket(fileno=descriptor), ROLES)
