"""Engines, as workers know them."""

from __future__ import annotations

from collections.abc import MutableSequence
from typing import Any, Protocol

from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.python.run_counter import PartwiseEngine
from allworlds.engines.python.scope import Scope
from allworlds.explorers import Subject


class WorkerEngine(Protocol):
    """An engine for workers: it is sent to their referees."""

    @property
    def scope(self) -> Scope:
        """The worlds and the rules of the check."""

    @property
    def keep(self) -> int:
        """The number of findings that are kept."""

    def tally(self) -> Any:
        """Return an empty result."""

    def for_built_in(
        self, subject: Subject, beat: MutableSequence[int] | None = None
    ) -> PartwiseEngine:
        """The engine with a built-in explorer, which is played in the calling process.

        Args:
            subject: the explorer.
            beat: see :func:`allworlds.judging.episode.play`.
        """

    def for_users(self, explorer: str, players: PlayerPair) -> PartwiseEngine:
        """The engine with the user's explorer of that name, in these two processes."""
