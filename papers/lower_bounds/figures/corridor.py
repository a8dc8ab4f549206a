"""Draw ``corridor.svg``: a corridor with two near hubs and one far hub.

``python papers/lower_bounds/figures/corridor.py`` writes it anew.  Each hub has its darts in their
true order.
"""

from __future__ import annotations

import sys
from cmath import rect
from math import pi, tau
from pathlib import Path
from xml.etree import ElementTree as ET

sys.path += [str(Path(__file__).parents[1]), str(Path(__file__).parents[3] / "docs" / "figures")]

from frame import framed, tag

from corridors import Corridor, Shape, drawn_corridor

FILE = Path(__file__).with_suffix(".svg")
SHAPE = Shape(1, 18)
WIDE, HIGH, RADIUS = 760, 250, 46.0
STYLE = """\
.hub { fill: #e4eaf0; stroke: #1c2126; stroke-width: 1.5; }
.v0 { fill: #ffe3b0; stroke: #c26a00; stroke-width: 3; }
.skeleton { fill: none; stroke: #1d5fa8; stroke-width: 2; }
.loop { fill: none; stroke: #8a949d; stroke-width: 1; }
.free { stroke: #b3261e; stroke-width: 2; }
.words { font-weight: 400; }
"""


def centre(level: int) -> complex:
    """The middle of a vertex."""
    return complex(50 + 205 * level, 105)


def end(corridor: Corridor, dart: int, radius: float) -> complex:
    """The point at which a dart leaves the circle of its vertex; clockwise, y goes downwards."""
    level = corridor.shape.level(dart)
    if level == 0:
        return centre(0) + rect(18, 0.6 if dart == 0 else -0.6)
    place = (dart - 2) % corridor.shape.degree
    # In-darts to the left.
    return centre(level) + rect(radius, pi - tau / 36 + tau * place / corridor.shape.degree)


def curve(corridor: Corridor, dart: int, name: str, reach: float) -> ET.Element:
    """An edge, drawn from one dart to the other; it leaves both at right angles."""
    ends = dart, corridor.alpha[dart]
    a, b = (end(corridor, d, RADIUS) for d in ends)
    p, q = (end(corridor, d, RADIUS + reach) for d in ends)
    path = f"M{a.real:.1f} {a.imag:.1f} C{p.real:.1f} {p.imag:.1f} {q.real:.1f} {q.imag:.1f} "
    return tag("path", class_=name, d=path + f"{b.real:.1f} {b.imag:.1f}", data_edge=f"{ends}")


def figure() -> ET.Element:
    """The whole figure."""
    corridor = drawn_corridor(SHAPE, 0)
    parts: list[ET.Element] = []
    for dart, other in enumerate(corridor.alpha):
        if dart < other:
            loop = corridor.shape.level(dart) == corridor.shape.level(other)
            name, reach = ("loop", 28.0) if loop else ("skeleton", 50.0)
            parts.append(curve(corridor, dart, name, reach))
    for dart in corridor.free:
        a, b = (end(corridor, dart, RADIUS + more) for more in (0, 14))
        sides = {"x1": a.real, "y1": a.imag, "x2": b.real, "y2": b.imag}
        parts.append(tag("line", class_="free", **{k: round(v, 1) for k, v in sides.items()}))
    parts.append(tag("circle", class_="v0", cx=50, cy=105, r=18))
    parts.append(tag("text", "v0", x=50, y=105))
    for hub in range(1, SHAPE.hubs + 1):
        at, kind = centre(hub), "near" if hub <= SHAPE.near else "far"
        parts.append(tag("circle", class_="hub", cx=round(at.real), cy=round(at.imag), r=RADIUS))
        parts.append(tag("text", f"{kind} hub {hub}", x=round(at.real), y=round(at.imag)))
    told = (
        "Blue: the edges between hubs, from two out-darts to two in-darts. Grey: loops.",
        "Red: free darts, which any perfect matching joins in pairs.",
    )
    for i, line in enumerate(told):
        parts.append(tag("text", line, class_="words", x=WIDE // 2, y=HIGH - 40 + 22 * i))
    return framed(
        "A corridor with two near hubs and one far hub",
        STYLE,
        WIDE,
        HIGH,
        *parts,
    )


def main() -> None:
    """Write the file."""
    FILE.write_text(ET.tostring(figure(), "unicode") + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
