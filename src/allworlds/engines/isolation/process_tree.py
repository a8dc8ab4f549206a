"""Processes and their descendants, by the interfaces of Linux.

Source: prctl(2), PR_SET_CHILD_SUBREAPER and PR_SET_PDEATHSIG.  Where they do not exist (macOS)
only the groups of its own children can be ended.
"""

from __future__ import annotations

import ctypes
import os
import signal
import sys
from contextlib import suppress

SUBREAPER, DEATH_SIGNAL = 36, 1
"""Options of :func:`control`."""

MOST_STOPS = 20
"""The number of looks at which a process may be found stopped, although it is always woken."""


def control(option: int, value: int = 1) -> None:
    """Call prctl, if the system has it."""
    if sys.platform == "linux":
        ctypes.CDLL(None, use_errno=True).prctl(option, int(value), 0, 0, 0)


def children_by_parent() -> dict[int, list[int]]:
    """The children of every process, read from /proc; empty without /proc.

    Cost: some 12 microseconds for each process of the machine.
    """
    found: dict[int, list[int]] = {}
    with suppress(FileNotFoundError):
        # A process may end while it is looked at, so that nothing but its own entry is asked for.
        for name in filter(str.isdigit, os.listdir("/proc")):  # noqa: PTH208
            with suppress(OSError, ValueError, IndexError):
                state, parent = _state_and_parent(name)
                if state != b"Z":
                    found.setdefault(int(parent), []).append(int(name))
    return found


def kill_tree(pid: int, *, itself: bool = True) -> None:
    """End a process's descendants, in all sessions, and the process itself.

    The process is stopped first, and its descendants are searched until there are no more, so
    that none of them can start another one unseen.
    """
    if itself:
        _signal(pid, signal.SIGSTOP)
    while True:
        family, waiting = [], [pid]
        children = children_by_parent()
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


def let_go_on(pid: int) -> None:
    """Let a process go on, if it was stopped."""
    _signal(pid, signal.SIGCONT)


def is_stopped(pid: int) -> bool:
    """Whether a process stands still since it was sent SIGSTOP, or a signal like that."""
    with suppress(OSError, ValueError):
        return _state_and_parent(str(pid))[0] == b"T"
    return False


def _state_and_parent(pid: str) -> tuple[bytes, bytes]:
    """The state of a process, a letter, and its parent's number, as /proc has them."""
    # Without a file object: every process is looked at whenever one is ended.
    descriptor = os.open(f"/proc/{pid}/stat", os.O_RDONLY | os.O_CLOEXEC)
    try:
        text = os.read(descriptor, 1 << 10)
    finally:
        os.close(descriptor)
    # The name in parentheses may hold anything, parentheses and blanks included.
    state, parent, *_ = text.rpartition(b")")[2].split(None, 2)
    return state, parent


class Stops:
    """The number of looks at which a process was found stopped."""

    def __init__(self) -> None:
        self.seen = 0

    def too_many(self, pid: int) -> bool:
        """Look at the process; return whether it was found stopped again and again."""
        self.seen += is_stopped(pid)
        return self.seen > MOST_STOPS


def _signal(pid: int, number: int) -> None:
    with suppress(ProcessLookupError, PermissionError):
        os.kill(pid, number)
