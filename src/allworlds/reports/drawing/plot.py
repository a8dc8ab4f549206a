"""Curves as SVG: values by the size of maps, on logarithmic axes."""

from collections.abc import Callable, Sequence
from math import log
from xml.etree import ElementTree as ET

from allworlds.reports.drawing.svg import tag
from allworlds.reports.parts import Curve

WIDTH, HEIGHT, LEFT, ABOVE = 480, 320, 60, 16
"""The size of the picture, and the left and the upper end of the axes, in pixels."""

RIGHT, BELOW = WIDTH - 20, HEIGHT - 44

COLOURS = ("#1f77b4", "#d62728", "#2a8a2a", "#9467bd", "#b8650a", "#7f7f7f")
"""The colours of the lines, in order; they are visible on a light and on a dark ground."""


def plot(curve: Curve) -> ET.Element:
    """The curve with its axes; the names of its lines are below, each in the colour of its line.

    At each point an upright line shows the confidence interval of the value; a value without an
    interval has no such line.
    """
    points = [point for _, line in curve.lines for point in line]
    across = _scale([x for x, *_ in points], LEFT, RIGHT)
    up = _scale([y for _, *ys in points for y in ys], BELOW, ABOVE)
    made = [tag("path", d=f"M{LEFT} {ABOVE}V{BELOW}H{RIGHT}", fill="none", stroke="currentColor")]
    for x in _ticks([x for x, *_ in points]):
        made.append(_text(across(x), BELOW + 18, f"{x:,g}", "middle"))
    for y in _ticks([y for _, *ys in points for y in ys]):
        made.append(_text(LEFT - 8, up(y) + 4, f"{y:,g}", "end"))
        made.append(tag("path", d=f"M{LEFT} {up(y)}H{RIGHT}", stroke="#8884"))
    made.append(_text((LEFT + RIGHT) / 2, HEIGHT - 6, curve.across, "middle"))
    for i, (name, line) in enumerate(curve.lines):
        colour, below = COLOURS[i % len(COLOURS)], HEIGHT + 20 * i + 14
        path = "L".join(f"{across(x)} {up(y)}" for x, y, *_ in line)
        bars = [f"M{across(x)} {up(low)}V{up(high)}" for x, _, low, high in line]
        drawn = f"M{path}{''.join(bars)}M{LEFT} {below - 4}h24"
        dash = f"{3 * (i // len(COLOURS))} 3" if i >= len(COLOURS) else None
        made.append(
            tag("path", d=drawn, fill="none", stroke=colour, stroke_width=2, stroke_dasharray=dash)
        )
        made += [tag("circle", cx=across(x), cy=up(y), r=3, fill=colour) for x, y, *_ in line]
        made.append(_text(LEFT + 32, below, name, "start"))
    view = f"0 0 {WIDTH} {HEIGHT + 20 * len(curve.lines)}"
    shown = [tag("title", curve.title), *made]
    return tag("svg", *shown, viewBox=view, role="img", class_="curve", xmlns=SVG)


SVG = "http://www.w3.org/2000/svg"


def _text(x: float, y: float, text: str, anchor: str) -> ET.Element:
    made = tag("text", text, x=x, y=y, text_anchor=anchor, class_=anchor, fill="currentColor")
    made.attrib |= {"font-size": "14", "font-family": "sans-serif"}
    return made


def _scale(values: Sequence[float], begin: float, end: float) -> Callable[[float], float]:
    """The function from a value to its coordinate, in pixels, on a logarithmic axis.

    The least of ``values`` has the coordinate ``begin``, the largest has ``end``.
    """
    least, most = log(min(values)), log(max(values))
    return lambda value: round(
        begin + (end - begin) * (log(value) - least) / (most - least or 1), 1
    )


def _ticks(values: Sequence[float]) -> list[float]:
    """The numbers to show at an axis: the values if there are at most 6, else round numbers."""
    found = sorted({*values})
    for steps in ((1, 2, 5), (1, 3), (1,)):
        if len(found) > 6:
            every = (step * 10.0**power for power in range(13) for step in steps)
            found = [each for each in every if min(values) <= each <= max(values)]
    return found
