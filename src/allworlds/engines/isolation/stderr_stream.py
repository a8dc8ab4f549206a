"""A stderr that may be lost: what explorers print there is no matter of the verdict."""

from __future__ import annotations

import io
import sys
from typing import Any, TextIO


def patient_stderr() -> TextIO:
    """Stderr as a text stream that forgets what cannot be written, be it full or unread.

    Otherwise ``print`` would be an error in whoever has the turn: an explorer would be refuted,
    or bad input have the exit code of an internal error.
    """
    return io.TextIOWrapper(
        io.BufferedWriter(_Patient(2, "w", closefd=False)),
        encoding=sys.stderr.encoding if sys.stderr else "utf-8",
        errors="backslashreplace",
        line_buffering=True,
    )


class _Patient(io.FileIO):
    """A file that takes everything."""

    def write(self, data: Any) -> int:
        """All of it, as far as the writer can see."""
        try:
            return super().write(data)
        except OSError:
            return len(data)
