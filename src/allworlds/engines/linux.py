"""System calls about processes and memory; those that only Linux has do nothing on other systems.

The package also works on other systems, because no verdict needs these calls.

Source: prctl(2), PR_SET_PDEATHSIG and PR_SET_CHILD_SUBREAPER; proc(5); getrlimit(2), RLIMIT_AS.
"""

import ctypes
import mmap
import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from allworlds.inputs.checks import InputError

HERE = sys.platform == "linux"
"""Whether the system is Linux.  A test sets it to False."""

DEATH_SIGNAL, SUBREAPER = 1, 36

COMPILER = "ALLWORLDS_COMPILER"
"""The environment variable that marks a process which compiles."""


def end_with_parent(parent: int, number: int = signal.SIGKILL) -> None:
    """Let the system signal this process when the thread that has started this process ends.

    ``number`` is the number of the signal; by default it ends this process.  ``parent`` is the
    number of the process with that thread.  If that process has already ended, this process exits
    at once.
    """
    if HERE:
        _control(DEATH_SIGNAL, number)
        if os.getppid() != parent:
            os._exit(1)  # it has ended already


def adopt() -> None:
    """Let this process become the parent of each of its descendants whose own parent ends."""
    if HERE:
        _control(SUBREAPER, 1)


def descendants(pid: int) -> list[int]:
    """The numbers of the processes that process ``pid`` has started, and of their descendants."""
    found = _children(pid) if HERE else []
    for one in found:
        found += _children(one)
    return found


def ended_within(seconds: float, child: int) -> int | None:
    """The exit code of a child process; None if it does not end within these seconds."""
    deadline = time.monotonic() + seconds
    while not (ended := os.waitpid(child, os.WNOHANG))[0] and time.monotonic() < deadline:
        time.sleep(0.005)
    return os.waitstatus_to_exitcode(ended[1]) if ended[0] else None


def end_adopted(token: str) -> None:
    """Kill the children of this process whose environment contains the text ``token``.

    These are processes that the explorer of a player has started in other process groups; they
    became children of this process when their parents ended.  The environments of all other
    children lack the text.
    """
    while HERE and (left := [pid for pid in _children(os.getpid()) if _has(pid, token)]):
        for pid in left:
            with suppress(ProcessLookupError, PermissionError):
                os.kill(pid, signal.SIGKILL)
            with suppress(ChildProcessError):
                os.waitpid(pid, 0)


@contextmanager
def compilers_ended() -> Iterator[None]:
    """A context in which an interrupt by the user also ends the compilers of this process.

    A compiler is a process that this process has started to compile the kernel.
    """
    try:
        yield
    except KeyboardInterrupt:
        for pid in descendants(os.getpid()):
            if _has(pid, COMPILER):
                with suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
        raise


def _children(parent: int) -> list[int]:
    found: list[int] = []
    with suppress(OSError):
        for task in os.listdir(f"/proc/{parent}/task"):  # noqa: PTH208
            with open(f"/proc/{parent}/task/{task}/children") as file:  # noqa: PTH123
                found += map(int, file.read().split())
    return found


def _has(pid: int, token: str) -> bool:
    with suppress(OSError), open(f"/proc/{pid}/environ", "rb") as file:  # noqa: PTH123
        return token.encode() in file.read()
    return False


def _control(option: int, value: int) -> None:
    ctypes.CDLL(None, use_errno=True).prctl(option, int(value), 0, 0, 0)


def address_space() -> int:
    """The address space of this process in MB; 0 if unknown."""
    with suppress(OSError, ValueError), open("/proc/self/statm") as file:  # noqa: PTH123
        return int(file.read().split()[0]) * mmap.PAGESIZE >> 20
    return 0


def limit_memory(megabytes: int) -> None:
    """Limit the address space of this process to this number of megabytes.

    Raises:
        InputError: if the address space is already larger than the limit.
    """
    if not HERE:
        return
    import resource

    _, most = resource.getrlimit(resource.RLIMIT_AS)
    size = min(megabytes << 20, sys.maxsize if most == resource.RLIM_INFINITY else most)
    # With such a limit a growing stack would end the process.
    too_small = size < address_space() << 20
    if not too_small:
        resource.setrlimit(resource.RLIMIT_AS, (size, size))
        try:
            mmap.mmap(-1, mmap.PAGESIZE).close()
        except OSError:
            too_small = True
    if too_small:
        raise InputError(
            f"memory {megabytes} MB is probably too small: a process is larger before it begins"
        )
