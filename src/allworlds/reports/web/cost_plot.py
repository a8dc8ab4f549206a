"""Cost against bound: a column for each size, as a drawing in a page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import groupby
from xml.etree import ElementTree as ET

from allworlds.reports.markup import tag
from allworlds.reports.telling import SizeCost
from allworlds.words import number, plural, size

COLUMN, BAR, HEIGHT, LEFT, TOP, FOOT = 30, 18, 180, 56, 24, 52
"""In pixels: from column to column, the width of a bar, and the room that the bars have."""


def plot(cells: Sequence[SizeCost], name: str) -> ET.Element:
    """The largest cost of each size as a bar, and its bound as a line above; ``name`` is its id."""
    top = max((max(cell.cost, cell.bound or 0) for cell in cells), default=0) or 1
    width = LEFT + COLUMN * len(cells) + 8

    def y(value: float) -> str:
        return f"{TOP + HEIGHT * (1 - value / top):.1f}"

    parts: list[ET.Element] = []
    for value in _ticks(top):
        parts.append(tag("path", class_="grid", d=f"M{LEFT - 4} {y(value)} H{width}"))
        parts.append(tag("text", number(value), class_="tick", x=LEFT - 8, y=y(value)))
    for i, cell in enumerate(cells):
        parts += _column(cell, LEFT + COLUMN * i + COLUMN // 2, y)
    at = LEFT
    for edges, group in groupby(cells, key=lambda cell: cell.edges):
        wide = COLUMN * len([*group])
        middle = at + wide // 2
        parts.append(tag("path", class_="brace", d=f"M{at + 4} {TOP + HEIGHT + 24} h{wide - 8}"))
        parts.append(tag("text", str(edges), x=middle, y=TOP + HEIGHT + 38))
        at += wide
    parts.append(tag("text", "vertices", class_="axis", x=LEFT - 6, y=TOP + HEIGHT + 14))
    parts.append(tag("text", "edges", class_="axis", x=LEFT - 6, y=TOP + HEIGHT + 38))
    return tag(
        "svg",
        tag("title", "The largest cost of each size against its bound", id=f"{name}-title"),
        tag("desc", " ".join(map(_in_words, cells)), id=f"{name}-desc"),
        *parts,
        id=name,
        class_="plot",
        role="img",
        aria_labelledby=f"{name}-title {name}-desc",
        viewBox=f"0 0 {width} {TOP + HEIGHT + FOOT}",
        width=width,
        height=TOP + HEIGHT + FOOT,
        xmlns="http://www.w3.org/2000/svg",
    )


def _column(cell: SizeCost, middle: int, y: Callable[[float], str]) -> list[ET.Element]:
    left, foot = middle - BAR // 2, TOP + HEIGHT
    parts = [
        tag("path", class_="cost", d=f"M{left} {foot} V{y(cell.cost)} h{BAR} V{foot} Z"),
        tag("text", str(cell.vertices), x=middle, y=foot + 14),
    ]
    if cell.bound is not None:
        parts.append(tag("path", class_="bound", d=f"M{left - 4} {y(cell.bound)} h{BAR + 8}"))
    return parts


def _ticks(top: int) -> list[int]:
    """Round numbers from 0 to the top, four or so."""
    step = 1
    while top / step > 5:
        step *= 5 if str(step).startswith("2") or (step == 1 and top > 10) else 2
    return [*range(0, top + 1, step)]


def _in_words(cell: SizeCost) -> str:
    most = "" if cell.bound is None else f" of at most {number(cell.bound)}"
    return f"{size(cell.edges, cell.vertices)}: {plural(cell.cost, 'traversal')}{most}."
