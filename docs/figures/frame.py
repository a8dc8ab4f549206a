"""The frame that the drawings of the pages share: a sheet of paper with a title for readers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from allworlds.reports.drawing.svg import tag

if TYPE_CHECKING:
    from xml.etree import ElementTree as ET

STYLE = """
svg { font: 600 13px system-ui, sans-serif; }
rect.paper { fill: #fdfdfb; }
text { fill: #1c2126; text-anchor: middle; dominant-baseline: central; }
"""
"""The style of every drawing, before that of its own parts."""


def framed(title: str, style: str, wide: int, high: int, *parts: ET.Element) -> ET.Element:
    """The SVG element of a drawing, with a title, and with its parts on paper."""
    return tag(
        "svg",
        tag("title", title, id="title"),
        tag("style", STYLE + style),
        tag("rect", class_="paper", width=wide, height=high),
        *parts,
        xmlns="http://www.w3.org/2000/svg",
        viewBox=f"0 0 {wide} {high}",
        width=wide,
        height=high,
        role="img",
        aria_labelledby="title",
    )
