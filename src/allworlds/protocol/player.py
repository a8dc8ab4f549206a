"""An explorer as the harness calls it."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any, Protocol

from allworlds.protocol.choices import Choices
from allworlds.protocol.percept import Percept


class Player(Protocol):
    """An explorer ready to run: its optional keywords are already bound."""

    def __call__(
        self, first: Percept, choices: Choices, told: int | None
    ) -> Generator[Any, Any, Any]:
        """The generator of one run."""
