"""A stderr that may be lost: no verdict depends on what explorers print there."""

from __future__ import annotations

import io
import sys
from typing import Any, TextIO


def patient_stderr() -> TextIO:
    """Stderr as a text stream that drops texts which cannot be written, if it is full or unread.

    Otherwise ``print`` would raise in the code that calls it: an explorer would be refuted, or
    bad input have the exit code of an internal error.
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
        """Write, and report the whole length as written."""
        try:
            return super().write(data)
        except OSError:
            return len(data)
