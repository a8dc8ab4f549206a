"""Layout of tables, named paragraphs and fenced texts."""

from __future__ import annotations

import re
import sys
from collections.abc import Sequence
from textwrap import wrap

GAP = 2
"""Columns of a table are so far apart."""

INDENT = 11
"""The columns before the text of a named paragraph."""

NARROWEST_TEXT = 12
"""A last column of text is not made narrower than this."""


def table(
    header: Sequence[str],
    rows: Sequence[Sequence[str]],
    right: str = "",
    width: int = sys.maxsize,
    keys: int = 1,
) -> list[str]:
    """Lines of a table; column i is flushed right where ``right[i]`` is ``r``.

    What is wider than ``width`` has its last column wrapped, if that is flushed left and the rest
    leaves room for it.  Else it is cut into tables one below the other: each has as many columns as
    fit, and begins with the first ``keys`` ones, by which rows are told apart.  Where not even one
    column fits beside these, each row is a list of named cells.
    """
    lines = [header, *rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    if sum(widths) + GAP * (len(widths) - 1) <= width:
        return _lines(lines, widths, right)
    room = width - sum(widths[:-1]) - GAP * (len(widths) - 1)
    if right[len(header) - 1 :] != "r" and room >= NARROWEST_TEXT:
        return _lines(_wrapped(lines, room), [*widths[:-1], room], right)
    blocks = _blocks(widths, width, keys)
    if any(_wide(widths, block) > width for block in blocks):
        return _listed(header, rows, width)
    told: list[str] = []
    for block in blocks:
        cells = [[line[i] for i in block] for line in lines]
        flushed = "".join(right[i : i + 1] or "l" for i in block)
        told += [*([""] if told else []), *table(cells[0], cells[1:], flushed, width, keys)]
    return told


def _wide(widths: Sequence[int], block: Sequence[int]) -> int:
    """Total width of a table with these columns."""
    return sum(widths[i] for i in block) + GAP * (len(block) - 1)


def _listed(header: Sequence[str], rows: Sequence[Sequence[str]], width: int) -> list[str]:
    """Each row as a list of its cells by their names, those that are empty left out."""
    told: list[str] = []
    for row in rows:
        told += [""] if told else []
        for name, cell in zip(header, row, strict=True):
            told += entry(name, cell, max(width, INDENT + NARROWEST_TEXT)) if cell else []
    return told


def _lines(lines: Sequence[Sequence[str]], widths: Sequence[int], right: str) -> list[str]:
    texts = []
    for line in lines:
        cells = [
            cell.rjust(width) if right[i : i + 1] == "r" else cell.ljust(width)
            for i, (cell, width) in enumerate(zip(line, widths, strict=True))
        ]
        texts.append((" " * GAP).join(cells).rstrip())
    return texts


def _wrapped(lines: Sequence[Sequence[str]], room: int) -> list[list[str]]:
    """Lines in which the last cell is wrapped to this width, continued below itself."""
    told = []
    for *cells, last in lines:
        parts = wrap(last, room, break_on_hyphens=False) or [""]
        told += [[*cells, parts[0]], *([*("" for _ in cells), part] for part in parts[1:])]
    return told


def _blocks(widths: Sequence[int], width: int, keys: int) -> list[list[int]]:
    """Columns of each table, when one table is cut into several."""
    blocks = [[*range(keys)]]
    for column in range(keys, len(widths)):
        block = [*blocks[-1], column]
        if _wide(widths, block) <= width or len(blocks[-1]) == keys:
            blocks[-1] = block
        else:
            blocks.append([*range(keys), column])
    return blocks


def entry(name: str, text: str, width: int) -> list[str]:
    """A named paragraph with a hanging indent."""
    first, indent = f"{name} ".ljust(INDENT), " " * INDENT
    return wrap(
        text, width, initial_indent=first, subsequent_indent=indent, break_on_hyphens=False
    ) or [name]


def fenced(text: str) -> str:
    """The text as a block of Markdown, in a fence that is longer than any in the text."""
    longest = max((len(run) for run in re.findall("`+", text)), default=0)
    fence = "`" * max(3, longest + 1)
    return f"{fence}text\n{text}\n{fence}"
