"""Curve of traversals against found edges, with the bound: as text and as a picture."""

from __future__ import annotations

from xml.etree import ElementTree as ET

from allworlds.judging import Spending
from allworlds.reports.markup import tag
from allworlds.reports.text_layout import table
from allworlds.words import plural

LONGEST = 12
"""Edges of which each has a line of its own; of more, so many are told, evenly spread."""

BAR = 40
"""The longest bar, in columns."""

WIDE, HIGH, LEFT, BELOW = 420, 220, 48, 40
"""The picture in pixels: the plot, and the room for the numbers beside and below it."""


def cost_lines(spent: Spending, width: int) -> list[str]:
    """The traversals up to each found edge as bars, then the total and the bound."""
    rows = [(f"edge {k}", at) for k, at in _told(spent)]
    rows += [("all", spent.cost), ("bound", spent.bound)]
    longest = max(1, *(at for _, at in rows))
    room = max(1, min(BAR, width - 24))
    cells = [
        [name, f"{at:,}", ("░" if name == "bound" else "█") * round(max(at, 0) * room / longest)]
        for name, at in rows
    ]
    return table(["found", "traversals", ""], cells, "lr")


def _told(spent: Spending) -> list[tuple[int, int]]:
    """Edges that get a line, each with the traversal that found it."""
    found = [*enumerate(spent.found, 1)]
    if len(found) <= LONGEST:
        return found
    last = len(found) - 1
    return [found[i * last // (LONGEST - 1)] for i in range(LONGEST)]


def cost_picture(spent: Spending, name: str) -> ET.Element:
    """The number of found edges after each traversal as a line, with the bound beside it."""
    most = max(spent.cost, spent.bound, 1)
    edges = max(len(spent.found), 1)

    def x(traversals: int) -> float:
        return round(LEFT + WIDE * max(traversals, 0) / most, 1)

    def y(found: int) -> float:
        return round(HIGH + 10 - HIGH * found / edges, 1)

    line = f"M{x(0)} {y(0)}"
    for found, at in enumerate(spent.found, 1):
        line += f" H{x(at)} V{y(found)}"
    line += f" H{x(spent.cost)}"
    said = (
        f"{plural(len(spent.found), 'edge')} found in {plural(spent.cost, 'traversal')}; "
        f"the bound is {spent.bound}."
    )
    svg = tag(
        "svg",
        tag("title", said, id=f"{name}-title"),
        tag("path", class_="axis", d=f"M{LEFT} 10 V{HIGH + 10} H{LEFT + WIDE}"),
        tag("path", class_="cost-bound", d=f"M{x(spent.bound)} 10 V{HIGH + 10}"),
        tag("path", class_="cost-line", d=line),
        tag("text", str(edges), x=LEFT - 16, y=y(edges)),
        tag("text", "0", x=LEFT - 16, y=y(0)),
        tag("text", f"bound {spent.bound}", x=x(spent.bound), y=HIGH + 24),
        tag("text", str(spent.cost), x=x(spent.cost), y=HIGH + 40),
        id=name,
        class_="curve",
        role="img",
        aria_labelledby=f"{name}-title",
        viewBox=f"0 0 {LEFT + WIDE + 32} {HIGH + 10 + BELOW}",
        width=LEFT + WIDE + 32,
        height=HIGH + 10 + BELOW,
        xmlns="http://www.w3.org/2000/svg",
    )
    caption = tag("figcaption", tag("b", "Edges found"), ", against traversals: ", said)
    return tag("figure", caption, tag("div", svg, class_="frame"))
