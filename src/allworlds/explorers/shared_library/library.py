"""A shared library, loaded; and its header."""

from __future__ import annotations

import ctypes
import hashlib
from contextlib import suppress
from pathlib import Path
from typing import Any

from allworlds.inputs.checks import InputError, existing_file, is_loop_of_links, show


def header_text() -> str:
    """The text of ``allworlds.h``."""
    return Path(__file__).with_name("allworlds.h").read_text(encoding="utf-8")


INTERFACE_VERSION = 2
"""The value of ``ALLWORLDS_VERSION``."""

ROOM = 1 << 18
"""The least capacity of an answer, in darts."""

MOVE, DROP, PICK, CHECKPOINT, ANSWER, AMBIGUOUS = range(1, 7)
"""The kinds of actions; in the header their names begin with ``ALLWORLDS_``."""

NOTHING = -1
"""The entry for no bearing, and for no number told."""


class CPercept(ctypes.Structure):
    """The C type ``struct allworlds_percept``."""

    _fields_ = (
        ("degree", ctypes.c_int32),
        ("marks", ctypes.c_int32),
        ("bearing", ctypes.c_int32),
    )


class CAction(ctypes.Structure):
    """The C type ``struct allworlds_action``."""

    _fields_ = (("kind", ctypes.c_int32), ("motion", ctypes.c_int32))


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
"""The types that each function returns and takes."""

_OPTIONAL = ("choose", "quotient")
"""The functions that a library need not have."""


def library_path(path: str) -> Path:
    """The file of a library, as an absolute path; raise InputError if there is none."""
    if not path:
        raise InputError("--native needs the path of a shared library, not an empty string")
    file = existing_file("--native", path)
    if file is None:
        reason = "it is a loop of links" if is_loop_of_links(path) else "there is no such file"
        reason = "it is a directory" if Path(path).is_dir() else reason
        raise InputError(f"--native {show(path)}: {reason}")
    return file


class Library:
    """A library whose functions can be called, and which has the present version.

    Loading runs the user's code.

    Attributes:
        digest: SHA-256 of the file, in hexadecimal.
        chooses: whether it takes choices.

    Raises:
        InputError: if it cannot be loaded, or is no library of an explorer.
    """

    def __init__(self, path: str) -> None:
        file = library_path(path)
        try:
            self.digest = hashlib.sha256(file.read_bytes()).hexdigest()
            self._loaded = ctypes.CDLL(str(file))
        except OSError as error:
            said = str(error).split("\n", 1)[0]
            raise InputError(f"--native {show(path)} is no library that loads: {said}") from None
        has_version, self.new, self.delete, self.start, self.step, self.answer, *more = (
            self._function(name, path) for name in _FUNCTIONS
        )
        self.choose, self.quotient = more
        self.chooses = self.choose is not None
        version = has_version()
        if version != INTERFACE_VERSION:
            raise InputError(
                f"--native {show(path)} is built with version {version} of allworlds.h; legal is "
                f"{INTERFACE_VERSION}: build it again with that of 'allworlds init --header'"
            )

    def print_line_by_line(self) -> None:
        """Make stdio write each line of stdout at once: a killed process would lose it."""
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
        """The addresses of start, step, answer and choose; 0 for one that is missing."""
        functions = (self.start, self.step, self.answer, self.choose)
        return [(ctypes.cast(each, _ADDRESS).value or 0) if each else 0 for each in functions]
