"""Draw ``docs/assets/darts.svg``: what dart, sigma, alpha and bearing mean, in one small world.

``python docs/figures/darts.py`` writes it anew.
"""

from __future__ import annotations

from cmath import phase, rect
from math import degrees, tau
from pathlib import Path
from xml.etree import ElementTree as ET

from frame import framed

from allworlds.documents.document import replace
from allworlds.maps import CombinatorialMap
from allworlds.reports.drawing.layout import Layout, layout
from allworlds.reports.drawing.svg import picture, tag
from allworlds.reports.parts import scene_of
from allworlds.world import Directional, World

FILE = Path(__file__).parents[1] / "assets" / "darts.svg"
WORLD = World(CombinatorialMap((1, 2, 0, 4, 3, 5), (3, 4, 5, 0, 1, 2)), Directional(2), 0)
"""Three darts round v0; the robot faces dart 0, and the marker points along dart 2."""

WIDE, HIGH = 640, 430
STYLE = """\
.edge { fill: none; stroke: #8a949d; stroke-width: 1.5; }
.stub, .robot { display: none; }
.here .robot { display: inline; fill: #b3261e; }
.here text { fill: #fdfdfb; }
.clockwise { display: none; }
.pole { fill: none; stroke: #c26a00; stroke-width: 3; }
.flag { fill: #c26a00; }
.disc { fill: #e4eaf0; stroke: #1c2126; stroke-width: 1.5; }
.marked .disc { fill: #ffe3b0; stroke: #c26a00; stroke-width: 3; }
.name { font-size: 11px; }
.dart text { paint-order: stroke; stroke: #fdfdfb; stroke-width: 4px; }
.box { fill: none; }
.start .box { fill: #fdfdfb; stroke: #1c2126; }
.start text { stroke: none; }
.turn { fill: none; stroke-width: 2.5; }
.sigma { stroke: #1d5fa8; fill: #1d5fa8; }
.alpha { stroke: #1a6b35; fill: #1a6b35; }
.bearing { stroke: #c26a00; fill: #c26a00; }
.turn { fill: none; }
text.bearing { fill: #8a4b00; }
.words { text-anchor: start; stroke: none; }
"""
TOLD = (
    ("dart", "A dart is half an edge: here 0 to 5. The robot (red) stands at dart 0."),
    ("sigma", "sigma(0) = 1: the next dart clockwise round the vertex."),
    ("alpha", "alpha(0) = 3: the other half of the edge. 'move 0' leads there, to v1."),
    ("bearing", "bearing 2: so many darts clockwise to the one that the marker points along."),
)


def direction(drawn: Layout, dart: int) -> float:
    """The angle at which a dart leaves its vertex; y goes downwards, so it grows clockwise."""
    return phase(drawn.stub(dart) - drawn.ways[dart][0])


def turn(drawn: Layout, start: int, end: int, radius: float, name: str) -> list[ET.Element]:
    """A clockwise arc with a head from one dart of a vertex to another."""
    centre = drawn.ways[start][0]
    begin, angle = direction(drawn, start), direction(drawn, end)
    swept = (angle - begin) % tau
    # Its ends lie a little beside the darts.
    begin, swept = begin + 0.12, swept - 0.34
    a, b = centre + rect(radius, begin), centre + rect(radius, begin + swept)
    large = int(swept > tau / 2)
    path = f"M{a.real:.1f} {a.imag:.1f} A{radius} {radius} 0 {large} 1 {b.real:.1f} {b.imag:.1f}"
    return [
        tag("path", class_=f"turn {name}", d=path, data_turn=f"{start} {end}"),
        head(b, begin + swept + tau / 4, name),
    ]


def head(at: complex, angle: float, name: str) -> ET.Element:
    """The head of an arrow."""
    turned = f"translate({at.real:.1f} {at.imag:.1f}) rotate({degrees(angle):.1f})"
    return tag("path", class_=name, d="M10 0 L-3 6 L-3 -6 Z", transform=turned)


def across(drawn: Layout, dart: int) -> list[ET.Element]:
    """An arrow beside a dart's edge, from the beginning of one half to that of the other."""
    a, b = drawn.stub(dart), drawn.stub(WORLD.map.alpha[dart])
    beside = (b - a) / abs(b - a) * -1j * 28
    begin, end = a + beside, b + beside
    line = f"M{begin.real:.1f} {begin.imag:.1f} L{end.real:.1f} {end.imag:.1f}"
    return [
        tag("path", class_="turn alpha", d=line, data_across=str(dart)),
        head(end, phase(b - a), "alpha"),
    ]


def figure() -> ET.Element:
    """The whole figure."""
    scene = replace(scene_of(WORLD), robot=WORLD.start)
    drawn = layout(WORLD.map, WORLD.start)
    left, top, width, height = drawn.box(40)
    world = picture(scene, "darts-world", "A world of three vertices")
    parts = [*world]
    parts += turn(drawn, 0, WORLD.map.sigma[0], 44.0, "sigma")
    parts += turn(drawn, 0, WORLD.lighthouse.dart, 60.0, "bearing")
    parts += across(drawn, 0)
    scale = min((HIGH - 110) / height, WIDE / width)
    shift = f"translate({WIDE / 2 - scale * (left + width / 2):.1f} {-scale * top:.1f})"
    group = tag("g", *parts, transform=f"{shift} scale({scale:.3f})")
    lines = [
        tag("text", text, class_=f"words {name}", x=20, y=HIGH - 88 + 24 * i)
        for i, (name, text) in enumerate(TOLD)
    ]
    return framed(
        "Dart, sigma, alpha and bearing in a world of three vertices",
        STYLE,
        WIDE,
        HIGH,
        group,
        *lines,
    )


def main() -> None:
    """Write the file."""
    FILE.write_text(ET.tostring(figure(), "unicode") + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
