"""Requests to a guardian, and their transmission."""

from __future__ import annotations

import pickle
import socket
import struct
from typing import Any

from msgspec import Struct

_LENGTH = struct.Struct("<I")
_MOST_DESCRIPTORS = 4


class Spawn(Struct, frozen=True):
    """Fork a process for a role.

    Attributes:
        role: the name of the role.
        directory, path, environment: of the process.
        relayed: the stderr that is sent along leads to a guardian already.
    """

    role: str
    directory: str
    path: list[str]
    environment: dict[str, str]
    relayed: bool = False


class EndProcesses(Struct, frozen=True):
    """Kill processes with all that they have started; answered when they have ended."""

    pids: tuple[int, ...]


class AskExitCode(Struct, frozen=True):
    """Ask for the exit code of a process."""

    pid: int


class Prepare(Struct, frozen=True):
    """Call a function without arguments: all that are forked later share the modules it loads.

    It is called once if it returns None; one that returns a number is called each time, and that is
    the answer.

    Attributes:
        module, function: its module, which belongs to this package, and its name.
    """

    module: str
    function: str


class ReachNursery(Struct, frozen=True):
    """Ask for a socket to the nursery with that hash seed; it is started if there is none."""

    seed: int


class ServeAnother(Struct, frozen=True):
    """Take the descriptor for the socket of another owner.  There is no answer."""


Request = Spawn | EndProcesses | AskExitCode | Prepare | ReachNursery | ServeAnother
Answer = int | None
"""A process's number to :class:`Spawn` and :class:`ReachNursery`; to :class:`AskExitCode` its exit
code (minus the signal), or None while it goes on; to :class:`Prepare` what was returned."""


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
