"""Prints of explorers as short texts, and a stderr that never raises; no verdict uses them."""

import io
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from itertools import accumulate
from typing import Any, TextIO

KEPT = 4096
"""The largest number of bytes of a text; if prints are longer, their middle is left out."""

SIGN = "\n[... {} bytes more ...]\n"
"""The line that stands for a middle that is left out; it says how many bytes are left out."""


class Prints:
    """A limited number of printed bytes, and their text.

    Attributes:
        ended: whether no further prints can come.
    """

    def __init__(self) -> None:
        self.ended = False
        self._first, self._last, self._size = bytearray(), bytearray(), 0

    def add(self, printed: bytes) -> None:
        """Add bytes; if more than twice :data:`KEPT` are held, drop bytes from the middle."""
        self._size += len(printed)
        room = KEPT - len(self._first)
        self._first += printed[:room]
        self._last += printed[room:]
        del self._last[: max(0, len(self._last) - KEPT)]

    @property
    def text(self) -> str:
        """The prints with control characters escaped, in at most :data:`KEPT` bytes."""
        letters = _letters(self._first)
        whole = "".join(shown for _, shown in letters)
        if self._size <= KEPT and len(whole.encode()) <= KEPT:
            return whole
        room = (KEPT - len(SIGN.format("9" * 15))) // 2
        first, before = _fitting(letters, room)
        last, after = _fitting(_letters((self._first + self._last)[-KEPT:])[::-1], room)
        return "".join(first) + SIGN.format(self._size - before - after) + "".join(last[::-1])


def _letters(printed: bytes | bytearray) -> list[tuple[int, str]]:
    """A pair for each printed character: the number of its bytes; and its text, maybe escaped."""
    letters = []
    for letter in printed.decode(errors="surrogateescape").replace("\r\n", "\n"):
        raw = letter.encode(errors="surrogateescape")
        shown = letter if letter in "\n\t" or letter.isprintable() else ascii(letter)[1:-1]
        letters.append((len(raw), f"\\x{raw[0]:02x}" if shown.startswith("\\udc") else shown))
    return letters


def _fitting(letters: Sequence[tuple[int, str]], room: int) -> tuple[list[str], int]:
    """The first characters that fit into ``room`` bytes, and how many printed bytes they stand for.

    ``letters`` is a list that :func:`_letters` has made.  An escaped character is longer than the
    printed bytes that it stands for.
    """
    sizes = accumulate(len(shown.encode()) for _, shown in letters)
    fitting = letters[: sum(size <= room for size in sizes)]
    return [shown for _, shown in fitting], sum(size for size, _ in fitting)


class _PrintStream(io.BytesIO):
    """A stream whose bytes are added to :class:`Prints`."""

    name = "<the explorer's prints>"

    def __init__(self, sink: Prints) -> None:
        self._sink = sink

    def write(self, printed: Any, /) -> int:
        """Add the bytes to the prints; return their number."""
        taken = bytes(printed)
        self._sink.add(taken)
        return len(taken)


@contextmanager
def printing_to(sink: Prints) -> Iterator[None]:
    """A context in which ``sink`` gets all that Python code in this process prints.

    Prints of compiled code and of other processes are not redirected.
    """
    written = io.TextIOWrapper(
        _PrintStream(sink), "utf-8", "backslashreplace", newline="", write_through=True
    )
    with redirect_stdout(written), redirect_stderr(written):
        yield


def patient_stderr() -> TextIO:
    """Stderr as a text stream that drops texts if it is full or nobody reads it.

    In these two cases ``print`` to Python's own stderr would raise an exception.  If an explorer
    prints, the exception would count as a crash of the explorer.  If the package prints a message
    about bad input, the command would end with the exit code of an internal error.
    """
    return io.TextIOWrapper(
        io.BufferedWriter(_Patient(2, "w", closefd=False)),
        encoding=sys.stderr.encoding if sys.stderr else "utf-8",
        errors="backslashreplace",
        line_buffering=True,
    )


class _Patient(io.FileIO):
    """A file whose writing never fails."""

    def write(self, data: Any) -> int:
        """Write the bytes as far as possible; return the number of all bytes, as if written."""
        try:
            return super().write(data)
        except OSError:
            return len(data)
