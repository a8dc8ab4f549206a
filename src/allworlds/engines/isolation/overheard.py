"""The prints of a player, recorded by its owner."""

from __future__ import annotations

import os
import select
import tempfile
import threading
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Self

from allworlds.engines.python.prints import Prints


class Overheard:
    """A named pipe that a player writes to in place of stdout and stderr, while this is entered.

    The pipe is read all the time, so that the player never waits; the record has a limited size.

    Attributes:
        path: that the player opens.
    """

    path = ""

    def __enter__(self) -> Self:
        self._directory = tempfile.TemporaryDirectory(prefix="allworlds-")
        self.path = str(Path(self._directory.name) / "printed")
        os.mkfifo(self.path, 0o600)
        # Open for both ends: no reader waits for a writer, and no writer for a reader.
        self._pipe = os.open(self.path, os.O_RDWR | os.O_NONBLOCK)
        self._woken, self._wake = os.pipe()
        self._prints = Prints()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        return self

    def __exit__(
        self, _: type[BaseException] | None, __: BaseException | None, ___: TracebackType | None
    ) -> None:
        os.write(self._wake, b".")
        self._reader.join()
        for descriptor in (self._pipe, self._woken, self._wake):
            os.close(descriptor)
        self._directory.cleanup()

    def _read(self) -> None:
        """Read until the end is signalled, then read the rest."""
        goes_on = True
        while goes_on:
            ready, _, _ = select.select([self._pipe, self._woken], [], [])
            goes_on = self._woken not in ready
            with suppress(BlockingIOError):
                while chunk := os.read(self._pipe, 1 << 16):
                    self._prints.add(chunk)

    @property
    def text(self) -> str:
        """The recorded prints, escaped and limited; complete after the context."""
        return self._prints.text
