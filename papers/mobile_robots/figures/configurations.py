"""Draw ``configurations.svg``: configurations beside schedules, both by the number of events.

``python papers/mobile_robots/figures/configurations.py`` counts them, and writes the picture anew.
"""

from __future__ import annotations

from collections import Counter
from math import log10
from xml.etree import ElementTree as ET

from strokes import keep, line, sheet, tag, words

import perpetual
from check import State, edges_of
from exploring import perpetual_new
from worlds import placements, places_of, steps_by

RING, EVENTS = 10, 60
LEFT, RIGHT, TOP, BOTTOM = 70, 560, 24, 340
COLOURS = {"ssync": "#c26a00", "async": "#1d5fa8"}
STYLE = """\
.grid { stroke: #dfe4e8; }
.counted { fill: none; stroke-width: 2.5; }
.met { stroke-dasharray: 6 4; }
"""


def counts(scheduler: str) -> tuple[list[int], list[int]]:
    """The schedules of 0, 1, 2, ... events from all starts, and the configurations that they meet.

    In async an event is a look or a move of one robot; the adversary's choices count, too.
    """
    rule = steps_by(perpetual.new)
    ways = Counter[State]((tuple(places_of(each)), (0, 0, 0)) for each in placements(RING, 3))
    schedules, configurations, met = [], [], set[State]()
    for _ in range(EVENTS + 1):
        met |= {*ways}
        schedules.append(ways.total())
        configurations.append(len(met))
        after = Counter[State]()
        for state, number in ways.items():
            for to, _group in edges_of(state, RING, rule, scheduler):
                after[to] += number
        ways = after
    return schedules, configurations


def raised(exponent: int) -> str:
    """An exponent."""
    return str(exponent).translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))


def figure() -> ET.Element:
    """The whole figure; the number of configurations in async is the one that the claim finds."""
    curves = {scheduler: counts(scheduler) for scheduler in COLOURS}
    tens = max(len(str(schedules[-1])) for schedules, _ in curves.values())

    def up(value: float) -> float:
        return round(BOTTOM - (BOTTOM - TOP) * log10(value) / tens, 2)

    def across(events: int) -> float:
        return round(LEFT + (RIGHT - LEFT) * events / EVENTS, 2)

    parts = []
    for exponent in range(0, tens + 1, 10):
        y = up(10**exponent)
        parts += [line(LEFT, y, RIGHT, y, "grid"), words("10" + raised(exponent), LEFT - 30, y)]
    for events in range(0, EVENTS + 1, 10):
        parts.append(words(str(events), across(events), BOTTOM + 18))
    for scheduler, colour in COLOURS.items():
        for kind, values in zip(("", "met"), curves[scheduler], strict=True):
            way = " ".join(f"{across(t)},{up(value)}" for t, value in enumerate(values))
            class_ = f"counted {kind}".strip()
            parts.append(tag("polyline", class_=class_, points=way, stroke=colour))
        told = f"schedules, {scheduler.upper()}"
        parts.append(words(told, RIGHT + 10, up(curves[scheduler][0][-1]), "start"))
    (claimed,) = perpetual_new(None, rings=[RING]).figures["configurations"]
    parts.append(words(f"{claimed} configurations in ASYNC,", RIGHT + 10, up(claimed) - 9, "start"))
    parts.append(words(f"{curves['ssync'][1][-1]} in SSYNC", RIGHT + 10, up(claimed) + 9, "start"))
    parts.append(words("events", (LEFT + RIGHT) / 2, BOTTOM + 40))
    title = "Configurations beside schedules: three robots that explore a ring of ten"
    return sheet(title, STYLE, 770, BOTTOM + 60, *parts)


if __name__ == "__main__":
    keep(__file__, figure())
