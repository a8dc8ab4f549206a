"""Explorers in shared libraries, whose functions the header ``allworlds.h`` declares.

Each buffer that a library gets ends at a protected page of memory, so that the process crashes if
the library reads or writes beyond the end of the buffer.
"""

import ctypes
import mmap
import os
import time
from collections.abc import Generator
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar, cast

from allworlds.inputs.checks import InputError, existing_file, is_loop_of_links, show
from allworlds.maps.combinatorial import CombinatorialMap, InvalidMap
from allworlds.protocol import actions
from allworlds.protocol.choices import KINDS, Choices


def header_text() -> str:
    """The text of the header ``allworlds.h``."""
    return Path(__file__).with_name("allworlds.h").read_text(encoding="utf-8")


INTERFACE_VERSION = 2
"""The version of the interface, ``ALLWORLDS_VERSION`` in ``allworlds.h``."""

ROOM = 1 << 18
"""The smallest number of darts for which a library gets memory to write its answer."""

MOVE, DROP, PICK, CHECKPOINT, ANSWER, AMBIGUOUS = range(1, 7)
"""The kinds of actions; in the header their names begin with ``ALLWORLDS_``."""

NOTHING = -1
"""The number that a library gets in place of a bearing, or of a told number, if there is none."""


class CPercept(ctypes.Structure):
    """The C type ``struct allworlds_percept``."""

    _fields_ = tuple((name, ctypes.c_int32) for name in ("degree", "marks", "bearing"))


class CAction(ctypes.Structure):
    """The C type ``struct allworlds_action``."""

    _fields_ = tuple((name, ctypes.c_int32) for name in ("kind", "motion"))


_INTEGER, _ADDRESS = ctypes.c_int32, ctypes.c_void_p

Pick = ctypes.CFUNCTYPE(_INTEGER, _ADDRESS, _INTEGER, _INTEGER, ctypes.POINTER(_INTEGER))
"""The C type ``allworlds_pick``."""

_FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "version": (_INTEGER, ()),
    "new": (_ADDRESS, ()),
    "delete": (None, (_ADDRESS,)),
    "start": (None, (_ADDRESS, _ADDRESS, _INTEGER, _ADDRESS)),
    "step": (None, (_ADDRESS, _ADDRESS, _ADDRESS)),
    "answer": (_INTEGER, (_ADDRESS, _INTEGER, _ADDRESS, _ADDRESS, _ADDRESS)),
    "choose": (None, (_ADDRESS, _ADDRESS, _ADDRESS)),
    "quotient": (_INTEGER, (_ADDRESS, _INTEGER, *(_ADDRESS,) * 5)),
}
"""For each function of a library the type that it returns, and the types of its arguments."""

_OPTIONAL = ("choose", "quotient")
"""The functions that a library may lack."""


def library_path(path: str) -> Path:
    """The absolute path of the library at ``path``; raise InputError if there is no such file."""
    if not path:
        raise InputError("--native needs the path of a shared library, not an empty string")
    file = existing_file("--native", path)
    if file is None:
        reason = "it is a loop of links" if is_loop_of_links(path) else "there is no such file"
        reason = "it is a directory" if Path(path).is_dir() else reason
        raise InputError(f"--native {show(path)}: {reason}")
    return file


class Library:
    """A user's shared library, which has been loaded.

    Loading the library also runs code of it.

    Args:
        path: the path of the library's file.

    Attributes:
        new, delete, start, step, answer: the functions of these names in ``allworlds.h``.
        choose, quotient: the same; None if the library lacks the function.

    Raises:
        InputError: if the library cannot be loaded, lacks a function of ``allworlds.h``, or is
            built with another version of it.
    """

    def __init__(self, path: str) -> None:
        try:
            self._loaded = ctypes.CDLL(str(library_path(path)))
        except OSError as error:
            said = str(error).split("\n", 1)[0]
            raise InputError(f"--native {show(path)} is no library that loads: {said}") from None
        functions = [self._function(name, path) for name in _FUNCTIONS]
        has_version, self.new, self.delete, self.start, self.step, self.answer = functions[:6]
        self.choose, self.quotient = functions[6:]
        version = has_version()
        if version != INTERFACE_VERSION:
            raise InputError(
                f"--native {show(path)} is built with version {version} of allworlds.h; legal is "
                f"{INTERFACE_VERSION}: build it again with that of 'allworlds init --header'"
            )

    def print_line_by_line(self) -> None:
        """Let C code in this process write each line of stdout as soon as the line is complete.

        So no line that the user's library prints is lost if the process is killed.
        """
        program = ctypes.CDLL(None)
        with suppress(ValueError):  # a C library that calls it otherwise
            stdout = ctypes.c_void_p.in_dll(program, "stdout")
            program.setvbuf(stdout, None, 1, ctypes.c_size_t(0))  # 1: _IOLBF

    def _function(self, name: str, path: str) -> Any:
        function = getattr(self._loaded, f"allworlds_{name}", None)
        if function is not None:
            function.restype, function.argtypes = _FUNCTIONS[name]
        elif name not in _OPTIONAL:
            needed = ", ".join(f"allworlds_{each}" for each in _FUNCTIONS if each not in _OPTIONAL)
            raise InputError(
                f"--native {show(path)} has no function allworlds_{name}; needed are {needed}"
            )
        return function

    def addresses(self) -> list[int]:
        """The addresses of the library's functions start, step, answer and choose.

        The address of a missing function is 0.
        """
        functions = (self.start, self.step, self.answer, self.choose)
        return [(ctypes.cast(each, _ADDRESS).value or 0) if each else 0 for each in functions]


T = TypeVar("T")

_NO_ACCESS = 0


def guarded(kind: type[T]) -> T:
    """A new value of the :mod:`ctypes` type ``kind``, filled with zeros.

    The value ends where a page of memory without access begins.
    Source: mprotect(2).
    """
    size = ctypes.sizeof(kind)  # type: ignore[arg-type]
    whole = -(-size // mmap.PAGESIZE) * mmap.PAGESIZE
    # It is private, so that a copy that the explorer forks has its own memory.
    mine = mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS
    pages = mmap.mmap(-1, whole + mmap.PAGESIZE, flags=mine)
    start = ctypes.addressof(ctypes.c_char.from_buffer(pages))
    protect = ctypes.CDLL(None, use_errno=True).mprotect
    protect.argtypes = (ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int)
    if protect(start + whole, mmap.PAGESIZE, _NO_ACCESS):
        raise OSError(ctypes.get_errno(), "a page cannot be protected")
    value: Any = kind.from_address(start + whole - size)  # type: ignore[attr-defined]
    value.memory = pages  # keeps it
    return cast("T", value)


def _integers(length: int) -> ctypes.Array[ctypes.c_int32]:
    return guarded(ctypes.c_int32 * length)


THREADS_END = 0.5
"""The largest number of seconds to wait until the system no longer lists a joined thread."""


class NativeExplorer:
    """An explorer in a shared library; it plays one run (*episode*) after the other.

    Args:
        library: the loaded library.
    """

    def __init__(self, library: Library) -> None:
        self.library = library
        self._percept, self._action = guarded(CPercept), guarded(CAction)
        self._here, self._rooms = _integers(1), [_integers(ROOM) for _ in range(4)]
        self._sensed = 0
        self._state: int | None = None
        self._picks: Any = None

    @property
    def keywords(self) -> frozenset[str]:
        """The keywords of :meth:`explore` that have an effect: ``told``, and perhaps ``choices``.

        ``choices`` is one of them if the library has the function ``allworlds_choose``.
        """
        return frozenset({"told", "choices"} if self.library.choose else {"told"})

    def state(self) -> int:
        """The address of the state, the memory that the library keeps for its explorer.

        The first call of this method lets the library make the state by ``allworlds_new``; later
        calls return the same address, until :meth:`close` is called.

        Raises:
            ExplorerFault: if the library makes no state.
        """
        if self._state is None:
            self._state = self.library.new()
            if self._state is None:
                raise actions.ExplorerFault("crash", "allworlds_new returned NULL")
        return self._state

    def handed(self) -> tuple[Any, ...]:
        """Five new arrays of integers, by which compiled code exchanges values with the library.

        They are for the percept, the action, ``here``, sigma and alpha, in this order.
        """
        return tuple(map(_integers, (3, 2, 1, ROOM, ROOM)))

    def close(self) -> None:
        """Let the library delete its state."""
        state, self._state = self._state, None
        if state is not None:
            self.library.delete(state)

    def explore(
        self, first: actions.Percept, *, told: actions.Told = None, choices: Choices | None = None
    ) -> Generator[actions.Action | actions.Checkpoint, actions.Percept, actions.Answer]:
        """Play one episode: yield the library's actions, and return its answer.

        Args:
            first: the percept at the start.
            told: the value that the lighthouse tells before the start, or None.
            choices: the object that makes the choices (default: first in, first out).

        Raises:
            ExplorerFault: for an illegal action, choice or answer, and if threads that the library
                has started go on after the answer.
        """
        threads = threads_now()
        library, action, state = self.library, self._action, self.state()
        here, there = ctypes.addressof(self._percept), ctypes.addressof(action)
        asked = _Asked(choices)
        if library.choose is not None:
            self._picks = Pick(asked.pick)  # the library may still call the picker
            library.choose(state, self._picks, None)
        self._sensed = 0
        self._sense(first)
        action.kind = action.motion = 0
        library.start(state, here, _one_number(told), there)
        while True:
            asked.complain()
            kind = action.kind
            if kind == MOVE:
                self._sense((yield actions.Move(action.motion)))
            elif kind == CHECKPOINT:
                sigma, alpha = self._said(library.answer, 2, "illegal-action")
                yield actions.Checkpoint(sigma, alpha, self._here[0])
            elif kind in (ANSWER, AMBIGUOUS):
                answer = self._estimate() if kind == ANSWER else self._ambiguous()
                if left := threads_left(threads):
                    what = "a thread" if left == 1 else f"{left} threads"
                    raise actions.ExplorerFault("crash", f"{what} left behind")
                return answer
            elif kind in (DROP, PICK):
                self._sense((yield actions.Drop() if kind == DROP else actions.Pick()))
            else:
                raise actions.ExplorerFault("illegal-action", f"an action of kind {kind}")
            action.kind = action.motion = 0
            library.step(state, here, there)

    def _sense(self, percept: actions.Percept) -> None:
        """Write the percept to the memory where the library reads it."""
        ours = self._percept
        self._sensed += percept.degree
        ours.degree, ours.marks = percept.degree, percept.marks
        ours.bearing = NOTHING if percept.bearing is None else percept.bearing

    def _said(self, function: Any, lists: int, law: actions.FaultLaw) -> list[tuple[int, ...]]:
        """Call a function of the library that writes an answer; return the lists that it writes.

        Each list has an integer for each dart.  The library's function returns the number of darts,
        and also writes ``here``, to ``self._here``.

        Args:
            function: ``allworlds_answer`` or ``allworlds_quotient``.
            lists: the number of lists: 2 (sigma, alpha), or 4 (also degree, marks).
            law: the law that is broken if the number of darts is illegal.

        Raises:
            ExplorerFault: if the number of darts is negative, or there is no room for so many.
        """
        if self._sensed > len(self._rooms[0]):
            self._rooms = [_integers(2 * self._sensed) for _ in range(4)]
        self._here[0] = NOTHING
        rooms, capacity = self._rooms[:lists], len(self._rooms[0])
        addresses = map(ctypes.addressof, (*rooms, self._here))
        darts = function(self.state(), capacity, *addresses)
        if not 0 <= darts <= capacity:
            raise actions.ExplorerFault(law, f"{darts} darts, where there is room for {capacity}")
        return [tuple(room[:darts]) for room in rooms]

    def _estimate(self) -> actions.Estimate:
        sigma, alpha = self._said(self.library.answer, 2, "no-estimate")
        try:
            return actions.Estimate(CombinatorialMap(sigma, alpha), self._here[0])
        except InvalidMap as error:
            raise actions.ExplorerFault("no-estimate", f"no map: {error}", error.tried) from None

    def _ambiguous(self) -> actions.Ambiguous:
        quotient = self.library.quotient
        if quotient is None:
            there_is_none = f"an action of kind {AMBIGUOUS}, but no function allworlds_quotient"
            raise actions.ExplorerFault("illegal-action", there_is_none)
        sigma, alpha, degree, marks = self._said(quotient, 4, "no-estimate")
        return actions.Ambiguous(sigma, alpha, degree, marks, self._here[0])


def _one_number(told: actions.Told) -> int:
    """The number that a library is told before the start; :data:`NOTHING` if there is none.

    ``told`` is the value that the lighthouse tells.  It holds at most one number, because a
    lighthouse that tells several numbers is refused earlier.
    """
    if told is None or isinstance(told, int):
        return NOTHING if told is None else told
    return next(iter(told.values()), NOTHING)


class _Asked:
    """The choices that a library asks for in one episode.

    Args:
        choices: the object that makes the choices (default: first in, first out).
    """

    def __init__(self, choices: Choices | None) -> None:
        self._choices = choices or Choices()
        self._wrong = ""

    def pick(self, _: int | None, of: int, options: int, cost: Any) -> int:
        """The index of the chosen option, which answers the library's call of ``allworlds_pick``.

        After an illegal call the index is 0, and :meth:`complain` raises the error later.

        Args:
            _: the context that the library passes; it is not used.
            of: the kind of the choice, as an index of :data:`KINDS`.
            options: the number of options.
            cost: a C array with the walking distance of each option, or a null pointer.
        """
        try:
            kind = KINDS[of] if 0 <= of < len(KINDS) else str(of)
            costs = cost[: max(options, 0)] if cost else None
            index: int = self._choices.pick(range(options), of=kind, cost=costs)  # type: ignore[arg-type]
        except ValueError as error:
            self._wrong = self._wrong or str(error)
            return 0
        return index

    def complain(self) -> None:
        """Raise ExplorerFault if the library has asked for an illegal choice."""
        if self._wrong:
            raise actions.ExplorerFault("crash", f"a choice that is none: {self._wrong}")


def threads_now() -> int:
    """The number of threads of this process; 0 if unknown."""
    with suppress(OSError):
        return len(os.listdir("/proc/self/task"))  # noqa: PTH208  # as short as it can be
    return 0


def threads_left(before: int) -> int:
    """The number of threads by which this process has more than ``before``; 0 if it has not more.

    The function waits a short time for threads that are ending, because the system still lists a
    thread for some microseconds after the thread has been joined.
    """
    deadline = time.monotonic() + THREADS_END
    while (more := threads_now() - before) > 0 and time.monotonic() < deadline:
        time.sleep(0.001)
    return max(0, more)
