"""Tables and named paragraphs."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from textwrap import wrap

GAP = 2
"""Columns of a table are so far apart."""

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
    fit, and begins with the first ``keys`` ones, by which rows are told apart.
    """
    lines = [header, *rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    if sum(widths) + GAP * (len(widths) - 1) <= width:
        return _lines(lines, widths, right)
    room = width - sum(widths[:-1]) - GAP * (len(widths) - 1)
    if right[len(header) - 1 :] != "r" and room >= NARROWEST_TEXT:
        return _lines(_wrapped(lines, room), [*widths[:-1], room], right)
    first, *others = _blocks(widths, width, keys)
    if not others:  # one column beside the keys is wider than there is room
        return _lines(lines, widths, right)
    told: list[str] = []
    for block in (first, *others):
        cells = [[line[i] for i in block] for line in lines]
        flushed = "".join(right[i : i + 1] or "l" for i in block)
        told += [*([""] if told else []), *table(cells[0], cells[1:], flushed, width, keys)]
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
    """The lines with the last cell of each in so much room; what goes on is below it."""
    told = []
    for *cells, last in lines:
        parts = wrap(last, room, break_on_hyphens=False) or [""]
        told += [[*cells, parts[0]], *([*("" for _ in cells), part] for part in parts[1:])]
    return told


def _blocks(widths: Sequence[int], width: int, keys: int) -> list[list[int]]:
    """The columns of the tables into which one is cut."""
    blocks = [[*range(keys)]]
    for column in range(keys, len(widths)):
        block = [*blocks[-1], column]
        fits = sum(widths[i] for i in block) + GAP * (len(block) - 1) <= width
        if fits or len(blocks[-1]) == keys:
            blocks[-1] = block
        else:
            blocks.append([*range(keys), column])
    return blocks


def entry(name: str, text: str, width: int) -> list[str]:
    """A named paragraph with a hanging indent."""
    indent = 11
    lines = wrap(text, max(width - indent, 20), break_on_hyphens=False) or [""]
    return [(f"{name} " if i == 0 else "").ljust(indent) + line for i, line in enumerate(lines)]


def in_lines(items: Sequence[str], width: int) -> list[str]:
    """Lines with as many of the items in each as fit; none is broken."""
    held = "   ".join(item.replace(" ", "\0") for item in items)
    return [line.replace("\0", " ") for line in wrap(held, width, break_long_words=False)]


def interruption(*, complete: bool, width: int) -> list[str]:
    """A paragraph for what the user has interrupted; nothing for what is complete."""
    text = "here stands what was finished before; nothing is known of the rest"
    return [] if complete else entry("INTERRUPTED", text, width)
