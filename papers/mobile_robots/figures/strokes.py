"""Lines, words and files of the paper's pictures; the modules of the paper can be imported."""

from __future__ import annotations

import sys
from pathlib import Path
from xml.etree import ElementTree as ET

sys.path += [str(Path(__file__).parents[1]), str(Path(__file__).parents[3] / "docs" / "figures")]
sys.path.append(str(Path(__file__).parents[3] / "examples" / "robots"))

from frame import framed, tag


def sheet(title: str, style: str, wide: int, high: int, *parts: ET.Element) -> ET.Element:
    """The whole picture."""
    return framed(title, ".words { font-weight: 400; }\n" + style, wide, high, *parts)


def line(x1: float, y1: float, x2: float, y2: float, class_: str, **more: str) -> ET.Element:
    """A line."""
    return tag("line", class_=class_, x1=x1, y1=y1, x2=x2, y2=y2, **more)


def words(text: str, x: float, y: float, anchor: str = "middle") -> ET.Element:
    """Some words, not bold."""
    style = None if anchor == "middle" else f"text-anchor: {anchor}"
    return tag("text", text, class_="words", x=x, y=y, style=style)


def written(figure: ET.Element) -> str:
    """The text of a picture's file."""
    return ET.tostring(figure, "unicode") + "\n"


def keep(program: str, figure: ET.Element) -> None:
    """Write a picture beside the program that draws it."""
    Path(program).with_suffix(".svg").write_text(written(figure), encoding="utf-8")
