"""What every figure has: a verdict, data, a caption, and a drawing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol, TypeAlias

from allworlds.outcome import Exit, Verdict

Table: TypeAlias = tuple[Sequence[str], Sequence[Sequence[object]]]
"""The names of the columns, and the rows; None is an empty field."""


class Drawn(Protocol):
    """A figure's content."""

    @property
    def verdict(self) -> Verdict:
        """Whether what is drawn is so."""

    @property
    def exit_code(self) -> Exit:
        """Of the command."""

    def table(self) -> Table:
        """The data."""

    def caption(self) -> Sequence[str]:
        """Sentences: what is seen, and where it differs from the paper."""

    def draw(self, figure: Any) -> None:
        """Draw it on an empty figure of matplotlib."""
