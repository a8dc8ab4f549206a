"""A shared library with the interface of ``allworlds.h``, loaded into this process."""

from __future__ import annotations

import ctypes
import hashlib
from pathlib import Path
from typing import Any

from allworlds.inputs import InputError, a_path, show

INTERFACE_VERSION = 1
"""``ALLWORLDS_VERSION``."""

ROOM = 1 << 18
"""The least capacity of an answer, in darts."""

MOVE, DROP, PICK, CHECKPOINT, ANSWER, AMBIGUOUS = range(1, 7)
KINDS_OF_ACTION = {
    "ALLWORLDS_MOVE": MOVE,
    "ALLWORLDS_DROP": DROP,
    "ALLWORLDS_PICK": PICK,
    "ALLWORLDS_CHECKPOINT": CHECKPOINT,
    "ALLWORLDS_ANSWER": ANSWER,
    "ALLWORLDS_AMBIGUOUS": AMBIGUOUS,
}
"""The kinds of actions by their names in the header."""

NOTHING = -1
"""No bearing, nothing told."""


class CPercept(ctypes.Structure):
    """``struct allworlds_percept``."""

    _fields_ = (
        ("degree", ctypes.c_int32),
        ("marks", ctypes.c_int32),
        ("bearing", ctypes.c_int32),
    )


class CAction(ctypes.Structure):
    """``struct allworlds_action``."""

    _fields_ = (("kind", ctypes.c_int32), ("motion", ctypes.c_int32))


_INTEGER, _ADDRESS = ctypes.c_int32, ctypes.c_void_p

Pick = ctypes.CFUNCTYPE(_INTEGER, _ADDRESS, _INTEGER, _INTEGER, ctypes.POINTER(_INTEGER))
"""``allworlds_pick``."""

_FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "version": (_INTEGER, ()),
    "new": (_ADDRESS, ()),
    "delete": (None, (_ADDRESS,)),
    "start": (None, (_ADDRESS, _ADDRESS, _INTEGER, _ADDRESS)),
    "step": (None, (_ADDRESS, _ADDRESS, _ADDRESS)),
    "answer": (_INTEGER, (_ADDRESS, _INTEGER, _ADDRESS, _ADDRESS, _ADDRESS)),
}
"""What each function returns and takes."""

_OPTIONAL: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "choose": (None, (_ADDRESS, _ADDRESS, _ADDRESS)),
    "quotient": (_INTEGER, (_ADDRESS, _INTEGER, *(_ADDRESS,) * 5)),
}
"""The same of those that a library need not have."""


def library_path(path: str) -> Path:
    """The file of a library, as an absolute path.

    Raises:
        InputError: if there is none.
    """
    if not path:
        raise InputError("--native needs the path of a shared library, not an empty string")
    file = a_path("--native", path).resolve()
    try:
        found = file.is_file()
    except OSError as error:
        raise InputError(f"--native {show(path)} cannot be read: {error.strerror}") from None
    if not found:
        raise InputError(f"--native {show(path)}: there is no such file")
    return file


class Library:
    """A library whose functions can be called, and which speaks our version.

    Loading runs foreign code.

    Attributes:
        digest: SHA-256 of the file, in hexadecimal.
        chooses: it asks where it is free.

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
        functions = {name: self._function(name, path) for name in _FUNCTIONS}
        self.new, self.delete = functions["new"], functions["delete"]
        self.start, self.step = functions["start"], functions["step"]
        self.answer = functions["answer"]
        self.choose, self.quotient = (self._optional(name) for name in ("choose", "quotient"))
        self.chooses = self.choose is not None
        version = functions["version"]()
        if version != INTERFACE_VERSION:
            raise InputError(
                f"--native {show(path)} is built with version {version} of allworlds.h; legal is "
                f"{INTERFACE_VERSION}"
            )

    def _function(self, name: str, path: str) -> Any:
        try:
            function = getattr(self._loaded, f"allworlds_{name}")
        except AttributeError:
            needed = ", ".join(f"allworlds_{each}" for each in _FUNCTIONS)
            raise InputError(
                f"--native {show(path)} has no function allworlds_{name}; needed are {needed}"
            ) from None
        function.restype, function.argtypes = _FUNCTIONS[name]
        return function

    def _optional(self, name: str) -> Any:
        function = getattr(self._loaded, f"allworlds_{name}", None)
        if function is not None:
            function.restype, function.argtypes = _OPTIONAL[name]
        return function

    def addresses(self) -> dict[str, int]:
        """Where the functions of an episode are, by name; 0 for ``choose`` if there is none."""
        functions = {name: getattr(self, name) for name in ("start", "step", "answer", "choose")}
        return {
            name: (ctypes.cast(function, _ADDRESS).value or 0) if function else 0
            for name, function in functions.items()
        }
