"""An explorer as the harness calls it."""

from __future__ import annotations

from collections.abc import Generator, Mapping
from typing import Any, Protocol, TypeAlias

from allworlds.protocol.actions import Percept
from allworlds.protocol.choices import Choices

Told: TypeAlias = int | Mapping[str, int] | None
"""The number, or the numbers by their names, that an explorer is told before the start."""


class Player(Protocol):
    """An explorer ready to run: its optional keywords are already bound."""

    def __call__(self, first: Percept, choices: Choices, told: Told) -> Generator[Any, Any, Any]:
        """Return the generator of one run."""
