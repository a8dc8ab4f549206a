"""Draw ``rule_sets.svg``: of the rule sets that gather three robots one of each kind.

``python papers/mobile_robots/figures/rule_sets.py`` finds them, and writes the picture anew.
"""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterator, Sequence
from math import pi, tau
from typing import Any
from xml.etree import ElementTree as ET

from strokes import keep, line, sheet, tag, words

from allworlds import Automaton
from check import ahead_of
from gathering import by_rules, every_rule_set, pairs, to_the_tower
from oblivious import gather_from
from worlds import arrangements, placements, places_of, steps_by

SCHEDULERS: tuple[Any, ...] = "fsync", "ssync", "async"
KINDS = ("FSYNC", "alone"), ("SSYNC", "not ASYNC"), ("ASYNC", "")
LEFT, TOP, ACROSS, DOWN, RADIUS = 150, 100, 118, 118, 36
STYLE = """\
.ring { fill: none; stroke: #b6bfc7; }
.vertex { fill: #b6bfc7; }
.robot { fill: #1d5fa8; }
.step { stroke: #c26a00; stroke-width: 2.5; }
"""


def kind(program: Automaton, vertices: int) -> int:
    """The number of schedulers in which a program gathers from all starts; each allows more."""
    for number, scheduler in enumerate(SCHEDULERS):
        starts = placements(vertices, 3)
        if not all(gather_from(start, vertices, program, scheduler) for start in starts):
            return number
    return len(SCHEDULERS)


def one_of_each(vertices: int) -> list[Automaton]:
    """The first rule set of each kind, where the third robot goes to two together."""
    found: dict[int, Automaton] = {}
    for rules in every_rule_set(pairs(vertices, (1, 1, 1))):
        program = by_rules({**rules, **to_the_tower(vertices)})
        found.setdefault(kind(program, vertices), program)
        if len(found) > len(SCHEDULERS):
            break
    return [found[number] for number in range(1, len(SCHEDULERS) + 1)]


def arrow(start: complex, end: complex) -> Iterator[ET.Element]:
    """An arrow between two points."""
    back = 8 * (start - end) / abs(start - end)
    for begin in (start, end + back * rect(1, 0.5), end + back * rect(1, -0.5)):
        ends = [round(value, 2) for value in (begin.real, begin.imag, end.real, end.imag)]
        yield line(*ends, "step")


def drawn(
    program: Automaton, places: Sequence[int], vertices: int, middle: complex
) -> Iterator[ET.Element]:
    """A ring with its robots, and each step that the rules allow them."""

    def dot(place: float, size: float, class_: str) -> ET.Element:
        point = middle + rect(RADIUS, tau * place / vertices - pi / 2)
        x, y = round(point.real, 2), round(point.imag, 2)
        return tag("circle", class_=class_, cx=x, cy=y, r=size)

    yield tag("circle", class_="ring", cx=middle.real, cy=middle.imag, r=RADIUS)
    yield from (dot(vertex, 3, "vertex") for vertex in range(vertices))
    for robot, place in enumerate(places):
        yield dot(place, 7, "robot")
        for step in steps_by(program)(ahead_of(places, robot, vertices)):
            if step:
                turns = (place + part * step for part in (0.08, 0.48))
                yield from arrow(
                    *(middle + rect(RADIUS + 13, tau * turn / vertices - pi / 2) for turn in turns)
                )


def figure() -> ET.Element:
    """The whole figure: a column for each start but for turns and reflections, a row for a kind."""
    parts, column = [], 0
    for row, (name, more) in enumerate(KINDS):
        y = TOP + DOWN * row
        parts += [tag("text", name, x=48, y=y - 9), words(more, 48, y + 9)]
    for vertices in (5, 7):
        starts = arrangements(vertices, 3)
        x = LEFT + ACROSS * (column + (len(starts) - 1) / 2)
        parts.append(tag("text", f"ring of {vertices}", x=x, y=24))
        programs = one_of_each(vertices)
        for start in starts:
            for row, program in enumerate(programs):
                middle = complex(LEFT + ACROSS * column, TOP + DOWN * row)
                parts += drawn(program, places_of(start), vertices, middle)
            column += 1
    told = "An arrow: that step. Two: either one. Where two are together, the third goes there."
    parts.append(words(told, LEFT + ACROSS * 2.2, TOP + DOWN * 2.7))
    title = "One of each kind of rule sets that gather three robots on rings of five and seven"
    return sheet(title, STYLE, LEFT + ACROSS * 6 - 30, TOP + DOWN * 3 - 10, *parts)


if __name__ == "__main__":
    keep(__file__, figure())
