"""Draw ``start_pairs.svg``: pairs of darts by Shrink, in the worlds of the claims.

``python papers/mobile_robots/figures/start_pairs.py`` counts them, and writes the picture anew.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from xml.etree import ElementTree as ET

from strokes import keep, line, sheet, tag, words

from allworlds import CombinatorialMap
from shrink import NAMED, shrink_by_walk, shrink_named, shrink_worlds

NAMES = "not symmetric", "Shrink 0", "Shrink 1", "Shrink 2", "Shrink 3"
COLOURS = "#c9d0d6", "#2d7d46", "#f0c27b", "#d9822b", "#8e2f1c"
CELL, LEFT, TOP, LEAST, GAP = 17, 20, 66, 96, 14
BARS, BAR, WIDE = 316, 26, 460
STYLE = ".dart { stroke: #8b959e; }\n"


def matrix(map_: CombinatorialMap, left: float, bottom: float) -> Iterator[ET.Element]:
    """A square for each pair of darts; a blank one if both have one vertex."""
    darts = sorted(map_.darts, key=lambda dart: (map_.vertex_of[dart], dart))
    top, size = bottom - CELL * len(darts), CELL * len(darts)
    for row, one in enumerate(darts):
        for column, other in enumerate(darts):
            if map_.vertex_of[one] != map_.vertex_of[other]:
                shrink = shrink_by_walk(map_, (one, other))
                colour = COLOURS[0 if shrink is None else shrink + 1]
                x, y, side = left + CELL * column, top + CELL * row, CELL - 1
                yield tag("rect", x=x, y=y, width=side, height=side, fill=colour)
    for number, (before, dart) in enumerate(pairwise(darts), 1):
        if map_.vertex_of[before] != map_.vertex_of[dart]:
            at = CELL * number - 0.5
            yield line(left + at, top, left + at, top + size, "dart")
            yield line(left, top + at, left + size, top + at, "dart")


def bar(name: str, numbers: list[int], top: float) -> Iterator[ET.Element]:
    """The numbers of pairs as one bar, and in words beside it."""
    left: float = LEFT + 90
    yield words(name, LEFT + 36, top + BAR / 2 - 3)
    for number, colour in zip(numbers, COLOURS, strict=False):
        width = round(WIDE * number / sum(numbers), 2)
        yield tag("rect", x=round(left, 2), y=top, width=width, height=BAR - 6, fill=colour)
        left += width
    told = " + ".join(f"{number:,}" for number in numbers)
    yield words(told, LEFT + WIDE + 104, top + BAR / 2 - 3, "start")


def figure() -> ET.Element:
    """The whole figure: a square for each pair in six worlds, and bars for all simple worlds."""
    parts, left, bottom = [], float(LEFT), TOP + CELL * 8
    for place, (name, colour) in enumerate(zip(NAMES, COLOURS, strict=True)):
        x = LEFT + 150 * place
        parts.append(tag("rect", x=x, y=24, width=CELL - 1, height=CELL - 1, fill=colour))
        parts.append(words(name, x + 26, 32, "start"))
    counted = shrink_named(None).figures
    for name, map_ in NAMED.items():
        size = CELL * len(map_.darts)
        room = max(size, LEAST)
        middle = left + room / 2
        parts += matrix(map_, middle - size / 2, bottom)
        parts.append(tag("text", name, x=middle, y=bottom + 18))
        parts.append(words(" + ".join(map(str, counted[name])), middle, bottom + 38))
        left += room + GAP
    parts.append(tag("text", "all simple worlds with a root, by edges", x=LEFT + 150, y=BARS - 26))
    for place, edges in enumerate((2, 3, 4, 5, 6)):
        found = shrink_worlds(None, edges=edges).figures
        numbers = [found["not symmetric"], *found["by Shrink"]]
        parts += bar(f"m <= {edges}", numbers, BARS + BAR * place)
    title = "Start pairs of two robots by Shrink"
    return sheet(title, STYLE, 800, BARS + BAR * 5 + 16, *parts)


if __name__ == "__main__":
    keep(__file__, figure())
