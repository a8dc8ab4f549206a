"""Memory for users' code: a write beyond its end ends the process."""

from __future__ import annotations

import ctypes
import mmap
from typing import Any, TypeVar, cast

T = TypeVar("T")

_NO_ACCESS = 0


class Guarded:
    """Zeroed memory of ``size`` bytes, right in front of a page without access rights.

    Args:
        size: bytes, a multiple of 4.

    Source: mprotect(2).
    """

    def __init__(self, size: int) -> None:
        page = mmap.PAGESIZE
        whole = -(-size // page) * page
        # Private: a copy of the process, forked by the explorer, has memory of its own.
        mine = mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS
        self._pages = mmap.mmap(-1, whole + page, flags=mine)
        start = ctypes.addressof(ctypes.c_char.from_buffer(self._pages))
        protect = ctypes.CDLL(None, use_errno=True).mprotect
        protect.argtypes = (ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int)
        if protect(start + whole, page, _NO_ACCESS):
            raise OSError(ctypes.get_errno(), "a page cannot be protected")
        self.address = start + whole - size

    def as_a(self, kind: type[T]) -> T:
        """The memory as a value of a type of :mod:`ctypes`."""
        value: Any = kind.from_address(self.address)  # type: ignore[attr-defined]
        value.memory = self  # keeps it
        return cast("T", value)
