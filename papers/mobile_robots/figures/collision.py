"""Draw ``collision.svg``: the shortest run of the rules of 2010 in which two robots collide.

``python papers/mobile_robots/figures/collision.py`` searches it, and writes the picture anew.
"""

from __future__ import annotations

from xml.etree import ElementTree as ET

from strokes import keep, line, sheet, tag, words

from exploring import as_steps, collisions
from worlds import places_of

RING, COLUMN, ROW, LEFT, TOP = 10, 52, 34, 120, 70
COLOURS = "#1d5fa8", "#c26a00", "#2d7d46"
STYLE = """\
.grid { stroke: #dfe4e8; }
.way { stroke-width: 3; fill: none; }
.due { stroke-width: 1.5; stroke-dasharray: 3 4; }
.end { fill: none; stroke: #b3261e; stroke-width: 3; }
"""


def figure() -> ET.Element:
    """The whole figure: vertices from left to right, the ring cut open, and time downwards."""
    start, found = min(collisions(RING), key=lambda each: each[0])
    places = [(place + 3) % RING for place in places_of(start)]
    events, due = as_steps(found), dict[int, tuple[float, int]]()
    parts, dots = [], []
    bottom = TOP + ROW * len(events)
    for name, place in zip("abc", places, strict=True):
        parts.append(tag("text", name, x=LEFT + COLUMN * place + 12, y=TOP + 8))
    for vertex in range(RING):
        x = LEFT + COLUMN * vertex
        parts.append(line(x, TOP - 10, x, bottom + 8, "grid"))
        parts.append(words(str((vertex - 3) % RING), x, TOP - 26))
    for number, event in enumerate(events, 1):
        y, moves = TOP + ROW * number, dict(event)
        written = " ".join(f"{'abc'[r]}{'M' if step is None else 'L'}" for r, step in event)
        parts.append(words(written, 44, y))
        for robot, place in enumerate(places):
            x, colour = LEFT + COLUMN * place, COLOURS[robot]
            to = x
            if robot in moves and moves[robot] is None:
                since, step = due.pop(robot)
                parts.append(line(x + 8 * step, since, x + 8 * step, y - ROW, "due", stroke=colour))
                places[robot], to = place + step, x + COLUMN * step
            elif robot in moves:
                due[robot] = y, moves[robot] or 0
                dots.append(tag("circle", cx=x, cy=y, r=6, fill="#fdfdfb", stroke=colour))
            parts.append(line(x, y - ROW, to, y, "way", stroke=colour))
    last = next(place for place in places if places.count(place) > 1)
    parts += [*dots, tag("circle", class_="end", cx=LEFT + COLUMN * last, cy=bottom, r=13)]
    told = "L: looks and decides (circle). M: makes that move. Dotted: decided, and not yet done."
    parts.append(words(told, 330, bottom + 40))
    title = "Three robots on a ring of ten vertices: two collide after twelve events"
    return sheet(title, STYLE, 660, bottom + 64, *parts)


if __name__ == "__main__":
    keep(__file__, figure())
