"""The stderr of processes, on its way to that of their owner.

Explorers may write any text.  But a CI service takes a line with ``::`` at its beginning for
a command of the program that it runs, and terminals obey controls that nobody sees.
"""

from __future__ import annotations

import os
import re
import select
from codecs import getincrementaldecoder
from contextlib import suppress

from allworlds.words import harmless

AT_ONCE = 1 << 16
"""The largest number of bytes that are read, and written, in one step."""

_BEGUN = re.compile(r"(?:#|##(?:v(?:so?)?)?)\Z")
"""The end of a line in whose middle a command may have begun."""


class Relay:
    """A pipe whose content is passed on, as far as it can be written without waiting."""

    def __init__(self) -> None:
        self._out, self._into = os.pipe()
        os.set_blocking(self._out, False)
        self._target = os.dup(2)
        self._decoder = getincrementaldecoder("utf-8")("backslashreplace")
        self._line = ""
        """The part of the line so far that may be the beginning of a command."""

    def fileno(self) -> int:
        """The descriptor from which it is read."""
        return self._out

    def leading_to(self, target: int) -> int:
        """A descriptor of the pipe, which a process can use as its stderr."""
        self.pass_on()
        os.close(self._target)
        self._target = target
        return os.dup(self._into)

    def pass_on(self) -> None:
        """Pass on the text that has been written by now."""
        with suppress(BlockingIOError):
            while part := os.read(self._out, AT_ONCE):
                self._write(self._decoder.decode(part))

    def _write(self, text: str) -> None:
        # The end of a command is changed, since its beginning may have been written before.
        shown = harmless(self._line + text)
        self._put(shown[len(self._line) :])
        *_, line = re.split(r"[\r\n]", shown)
        if line.strip():
            begun = _BEGUN.search(line)
            self._line = ":" if line.lstrip() == ":" else "x" + (begun[0] if begun else "")
        else:
            self._line = ""

    def _put(self, text: str) -> None:
        """Write a text, or drop it if there is no reader."""
        data = text.encode(errors="backslashreplace")
        poll = select.poll()
        poll.register(self._target, select.POLLOUT)
        for at in range(0, len(data), select.PIPE_BUF):
            if poll.poll(0):
                with suppress(OSError):
                    os.write(self._target, data[at : at + select.PIPE_BUF])
