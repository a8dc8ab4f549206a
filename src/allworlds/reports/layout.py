"""Tables and named paragraphs."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import wrap


def table(header: Sequence[str], rows: Sequence[Sequence[str]], right: str = "") -> list[str]:
    """Lines of a table; column i is flushed right where ``right[i]`` is ``r``."""
    lines = [header, *rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    texts = []
    for line in lines:
        cells = [
            cell.rjust(width) if right[i : i + 1] == "r" else cell.ljust(width)
            for i, (cell, width) in enumerate(zip(line, widths, strict=True))
        ]
        texts.append("  ".join(cells).rstrip())
    return texts


def entry(name: str, text: str, width: int) -> list[str]:
    """A named paragraph with a hanging indent."""
    indent = 11
    lines = wrap(text, max(width - indent, 30), break_on_hyphens=False) or [""]
    return [(f"{name} " if i == 0 else "").ljust(indent) + line for i, line in enumerate(lines)]


def interruption(*, complete: bool, width: int) -> list[str]:
    """A paragraph for what the user has interrupted; nothing for what is complete."""
    text = "here stands what was finished before; nothing is known of the rest"
    return [] if complete else entry("INTERRUPTED", text, width)
