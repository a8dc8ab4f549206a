"""Content that every figure has: a verdict, data, a caption and a drawing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol, TypeAlias

from allworlds.outcome import Facts

Table: TypeAlias = tuple[Sequence[str], Sequence[Sequence[object]]]
"""The names of the columns, and the rows; None is an empty field."""


class Drawn(Protocol):
    """Content of a figure, ready to be drawn."""

    @property
    def is_sample(self) -> bool:
        """Whether its worlds are drawn at random, so that nothing is known of all of them."""

    @property
    def facts(self) -> Facts:
        """Whether the figure's claims were found true."""

    def table(self) -> Table:
        """The data of the figure."""

    def caption(self) -> Sequence[str]:
        """Sentences that describe the figure, and its differences from the paper's."""

    def draw(self, figure: Any) -> None:
        """Draw it on an empty figure of matplotlib."""
