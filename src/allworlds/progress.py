"""Whoever wants to know how a long job gets on."""

from __future__ import annotations

from typing import Protocol


class Listener(Protocol):
    """Is told how a job gets on."""

    def level(self, edges: int, worlds: int) -> None:
        """A level begins; it holds so many worlds (a shard: about so many)."""

    def progress(self, worlds: int) -> None:
        """So many more worlds are done."""

    def notice(self, text: str) -> None:
        """Something that the user may want to know now."""


class Silent:
    """The listener who is not there."""

    def level(self, edges: int, worlds: int) -> None:
        """Nothing."""

    def progress(self, worlds: int) -> None:
        """Nothing."""

    def notice(self, text: str) -> None:
        """Nothing."""
