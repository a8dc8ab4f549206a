"""Listeners to the progress of a long job."""

from __future__ import annotations


class Listener:
    """A listener to the progress of a job; by default each event is ignored."""

    def level(self, edges: int, worlds: int) -> None:
        """Hear that a level begins, with its number of worlds (of a shard: about that many)."""

    def stage(self, name: str, total: int, of: str) -> None:
        """Hear that a part of another kind begins, with the number of its items, named ``of``."""

    def progress(self, count: int) -> None:
        """Hear how many more worlds, or other units of the stage, are done."""

    def notice(self, text: str) -> None:
        """Hear a message to the user."""


class Silent(Listener):
    """The listener that ignores all events."""


NOBODY = Silent()
"""The listener where none is named, and that of a report, which is equal to another if all else
is."""


class NoticeOnce(Silent):
    """A listener that hands on notices alone, and each of them once."""

    def __init__(self, listener: Listener) -> None:
        self._listener, self._said = listener, set[str]()

    def notice(self, text: str) -> None:
        """Hear a message to the user."""
        if text not in self._said:
            self._said.add(text)
            self._listener.notice(text)
