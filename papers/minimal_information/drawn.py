"""Content that every figure has: a verdict, data, a caption and a drawing; and its files."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Protocol, TypeAlias

Table: TypeAlias = tuple[Sequence[str], Sequence[Sequence[object]]]
"""The names of the columns, and the rows; None is an empty field."""


class Drawn(Protocol):
    """Content of a figure, ready to be drawn."""

    @property
    def right(self) -> bool:
        """Whether the figure's claims were found true."""

    def table(self) -> Table:
        """The data of the figure."""

    def caption(self) -> Sequence[str]:
        """Sentences that describe the figure, and its differences from the paper's."""

    def draw(self, figure: Any) -> None:
        """Draw it on an empty figure of matplotlib."""


def write(drawn: Drawn, picture: Path) -> bool:
    """Draw a figure into a file, write its data beside it as CSV, and print its caption.

    Return whether the figure's claims were found true.
    """
    import matplotlib as mpl
    from matplotlib.figure import Figure as Sheet

    # Without a salt the names in an SVG are drawn anew each time; without a date it is the same.
    with mpl.rc_context({"svg.hashsalt": "allworlds", "svg.fonttype": "none"}):
        sheet = Sheet(layout="constrained")
        drawn.draw(sheet)
        dated = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
        sheet.savefig(picture, dpi=150, metadata=dated.get(picture.suffix, {}))
    header, rows = drawn.table()
    with picture.with_suffix(".csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header, *rows])
    print(f"{picture}, {picture.with_suffix('.csv')}", *drawn.caption(), sep="\n")
    return drawn.right
