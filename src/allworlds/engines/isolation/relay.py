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

from allworlds.words import escaped

AT_ONCE = 1 << 16
"""The largest number of bytes that are read, and written, in one step."""

_COMMAND = re.compile(r"((?:\A|[\r\n])[^\S\r\n]*):(?=:)")
"""A colon that begins a command; a runner takes a carriage return for the end of a line, too."""


class Relay:
    """A pipe whose content is passed on, as far as it can be written without waiting."""

    def __init__(self) -> None:
        self._out, self._into = os.pipe()
        os.set_blocking(self._out, False)
        self._target = os.dup(2)
        self._decoder = getincrementaldecoder("utf-8")("backslashreplace")
        self._begun, self._kept = False, ""
        """Whether the line so far holds more than blanks, and a colon that may begin a command."""

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
        if self._kept:
            # Nobody knows whether another colon comes.
            self._put(r"\x3a")
            self._begun, self._kept = True, ""

    def _write(self, text: str) -> None:
        # A letter stands for the line so far, if it holds more than blanks.
        before = "x" * self._begun
        text, self._kept = before + self._kept + text, ""
        *_, line = re.split(r"[\r\n]", text)
        if line.strip() == ":" and line.endswith(":"):
            text, line, self._kept = text[:-1], "", ":"
        self._put(escaped(_COMMAND.sub(r"\1\\x3a", text))[len(before) :])
        self._begun = bool(line.strip())

    def _put(self, text: str) -> None:
        """Write a text, or drop it if there is no reader."""
        data = text.encode(errors="backslashreplace")
        poll = select.poll()
        poll.register(self._target, select.POLLOUT)
        for at in range(0, len(data), select.PIPE_BUF):
            if poll.poll(0):
                with suppress(OSError):
                    os.write(self._target, data[at : at + select.PIPE_BUF])
