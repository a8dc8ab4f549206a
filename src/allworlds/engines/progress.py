"""Whoever wants to know how a long job gets on."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


class Listener:
    """Is told how a job gets on; one that overrides nothing lets it pass."""

    def level(self, edges: int, worlds: int) -> None:
        """A level begins; it holds so many worlds (a shard: about so many)."""

    def stage(self, name: str, total: int, of: str) -> None:
        """A part of another kind begins: so many of what ``of`` says."""

    def progress(self, count: int) -> None:
        """So many more worlds, or others of what the stage is about, are done."""

    def unit(self, key: str, worlds: int) -> None:
        """The unit of that name is finished; it holds so many worlds."""

    def finding(self, document: Mapping[str, Any]) -> None:
        """A run that refutes was met in a unit that is finished; it is not confirmed yet."""

    def notice(self, text: str) -> None:
        """Something that the user may want to know now."""


class Silent(Listener):
    """The listener of those who do not want to know."""


class Once(Silent):
    """A listener who hands on notices alone, and each of them once."""

    def __init__(self, listener: Listener) -> None:
        self._listener, self._said = listener, set[str]()

    def notice(self, text: str) -> None:
        """Something that the user may want to know now."""
        if text not in self._said:
            self._said.add(text)
            self._listener.notice(text)
