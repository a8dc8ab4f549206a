"""A scene as a polygon whose sides are glued in pairs, in a page.

What follows the robot there is named as in the other pictures: an edge by its two darts, a dart
by its number, so that the same script steps in it.
"""

from __future__ import annotations

from cmath import phase
from collections.abc import Mapping
from math import degrees
from string import ascii_lowercase, ascii_uppercase
from xml.etree import ElementTree as ET

from allworlds.maps import Dart
from allworlds.reports.drawing.polygon import Polygon, polygon
from allworlds.reports.drawing.scene import Scene
from allworlds.reports.drawing.svg import in_words
from allworlds.reports.drawing.svg_parts import (
    COLOURS,
    at,
    curve,
    edge_along,
    rounded,
    stub,
    vertex_with,
)
from allworlds.reports.markup import tag

LETTERS = ascii_uppercase + ascii_lowercase
"""Names of edges that are cut."""

MOST_SIDES = 60
"""A polygon with more is not drawn."""

MARGIN = 50.0
"""The free room round it, in pixels."""

ASIDE = 17.0
"""How far outside of its side a letter stands, in pixels."""


def has_polygon(scene: Scene) -> bool:
    """Whether the surface is no sphere and its polygon has few enough sides to be read."""
    map_ = scene.map
    return map_.genus > 0 and 2 * (map_.edge_count - len(map_.faces) + 1) <= MOST_SIDES


def polygon_picture(scene: Scene, name: str, title: str) -> ET.Element:
    """The scene cut open, as an SVG element; see :func:`allworlds.reports.drawing.svg.picture`."""
    map_, cut = scene.map, polygon(scene.map, scene.start)
    letters = _letters(scene, cut)
    wide = round(cut.radius + MARGIN)
    inside = [dart for dart in cut.ways if dart < map_.alpha[dart]]
    outline = " L".join(map(at, cut.corners))
    return tag(
        "svg",
        tag("title", title, id=f"{name}-title"),
        tag("desc", f"{_round_it(scene, cut, letters)} {in_words(scene)}", id=f"{name}-desc"),
        tag("path", class_="region", d=f"M{outline} Z"),
        *(edge_along(scene, dart, curve(cut.ways[dart])) for dart in inside),
        *(stub(dart, way[0], (way[0] + way[1]) / 2) for dart, way in cut.ways.items()),
        *(part for place in range(len(cut.sides)) for part in _side(scene, cut, place, letters)),
        *(_corner(scene, cut, place) for place in range(len(cut.sides))),
        tag("g", class_="arrows"),
        id=name,
        class_="map polygon",
        role="img",
        aria_labelledby=f"{name}-title {name}-desc",
        viewBox=f"{-wide} {-wide} {2 * wide} {2 * wide}",
        width=2 * wide,
        height=2 * wide,
        xmlns="http://www.w3.org/2000/svg",
    )


def _letters(scene: Scene, cut: Polygon) -> dict[Dart, str]:
    """The letter of each side, by its dart. Both sides of an edge have the same letter."""
    named: dict[Dart, str] = {}
    letters = iter(LETTERS)
    for dart in cut.sides:
        other = scene.map.alpha[dart]
        named[dart] = named[other] if other in named else next(letters)
    return named


def _round_it(scene: Scene, cut: Polygon, letters: Mapping[Dart, str]) -> str:
    """The sides around the polygon in words, for readers who cannot see it."""
    names = scene.dart_names
    word = ", ".join(
        f"{letters[d]} {'' if _forwards(scene, d) else 'backwards '}from dart {names[d]}"
        for d in cut.sides
    )
    return f"Counterclockwise round the polygon its sides are: {word}."


def _forwards(scene: Scene, dart: Dart) -> bool:
    """Whether the arrow of the side leads away from the dart; true for the edge's smaller dart."""
    return dart < scene.map.alpha[dart]


def _side(
    scene: Scene, cut: Polygon, place: int, letters: Mapping[Dart, str]
) -> tuple[ET.Element, ...]:
    """The side, its beginning, and in its middle the arrow and the letter of the edge."""
    dart, (start, end) = cut.sides[place], cut.side(place)
    forwards, middle = _forwards(scene, dart), (start + end) / 2
    ahead = (end - start) / abs(end - start) * (1 if forwards else -1)
    outside = ASIDE * middle / abs(middle)
    colour = ""
    if scene.labels is None:
        colour = f" class-{sorted(set(letters.values())).index(letters[dart]) % COLOURS}"
    x, y = rounded(outside.real), rounded(outside.imag)
    left, top = rounded(outside.real - 8), rounded(outside.imag - 8)
    sign = tag(
        "g",
        tag("path", d="M9 0 L-6 -6 L-6 6 Z", transform=f"rotate({rounded(degrees(phase(ahead)))})"),
        tag("rect", class_="box", x=left, y=top, width=16, height=16, rx=3),
        tag("text", letters[dart], x=x, y=y),
        class_="fixed",
    )
    return (
        edge_along(scene, dart, f"M{at(start)} L{at(end)}"),
        stub(dart, start, start + (end - start) / 3),
        tag(
            "g",
            sign,
            class_=f"glue{colour}",
            data_side=dart,
            data_letter=letters[dart],
            transform=f"translate({at(middle)})",
        ),
    )


def _corner(scene: Scene, cut: Polygon, place: int) -> ET.Element:
    """A corner: its vertex, and the numbers of the darts that begin here."""
    start, end = cut.side(place)
    along = {d: (cut.ways[d][1] - start) / abs(cut.ways[d][1] - start) for d in cut.within[place]}
    along[cut.sides[place]] = (end - start) / abs(end - start)
    return vertex_with(scene, scene.map.vertex_of[cut.sides[place]], start, along)
