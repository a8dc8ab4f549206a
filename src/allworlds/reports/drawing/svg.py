"""A scene as a drawing in a page: the darts leave each vertex in their cyclic order, clockwise.

Edges scale with the drawing; what is written does not.  Vertices, numbers, the marker's arrow and
the robot stand in groups of the class ``fixed``, about the centre of their vertex, which a style
sheet scales by ``--k``, one over the scale of the drawing.
"""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import cos, pi, sin, tau
from xml.etree import ElementTree as ET

from allworlds.maps import Dart
from allworlds.reports.drawing.edge_points import bridges_of
from allworlds.reports.drawing.layout import Layout, layout
from allworlds.reports.drawing.scene import Scene
from allworlds.reports.drawing.svg_parts import at, curve, edge_along, stub, vertex_with
from allworlds.reports.markup import tag

MARGIN = 30.0
"""The free room round the drawing, in pixels."""

TURN = 16.5
"""The radius of the arrow that shows which way is clockwise."""


def picture(scene: Scene, name: str, title: str, drawn: Layout | None = None) -> ET.Element:
    """The scene as an SVG element; ``name`` is its id, ``title`` what a screen reader says.

    It is drawn as ``drawn`` says, by default as :func:`layout` does.
    """
    map_ = scene.map
    drawn = drawn or layout(map_, scene.start)
    left, top, width, height = (round(x) for x in drawn.box(MARGIN))
    return tag(
        "svg",
        tag("title", title, id=f"{name}-title"),
        tag("desc", in_words(scene), id=f"{name}-desc"),
        *(part for dart, _ in map_.edges for part in _edge(scene, drawn, dart)),
        *(stub(dart, drawn.ways[dart][0], drawn.stub(dart)) for dart in map_.darts),
        *(_vertex(scene, drawn, vertex) for vertex in range(map_.vertex_count)),
        tag("g", class_="arrows"),
        id=name,
        class_="map",
        role="img",
        aria_labelledby=f"{name}-title {name}-desc",
        viewBox=f"{left} {top} {width} {height}",
        width=width,
        height=height,
        xmlns="http://www.w3.org/2000/svg",
    )


def in_words(scene: Scene) -> str:
    """The scene in words, for readers who cannot see it."""
    map_, dart_names, vertex_names = scene.map, scene.dart_names, scene.vertex_names
    sentences = []
    for vertex, darts in enumerate(map_.vertices):
        ways = [
            f"{dart_names[dart]} to dart {dart_names[map_.alpha[dart]]} of "
            f"{vertex_names[map_.vertex_of[map_.alpha[dart]]]}"
            for dart in darts
        ]
        sentences.append(
            f"Clockwise round {vertex_names[vertex]} its darts lead: {', '.join(ways)}."
        )
    for vertex, marks in sorted(scene.marks.items()):
        sentences.append(f"Markers at {vertex_names[vertex]}: {marks}.")
    if scene.pointed:
        pointed = ", ".join(dart_names[dart] for dart in sorted(scene.pointed))
        sentences.append(f"Pointed darts: {pointed}.")
    if scene.labels is not None:
        labels = ", ".join(f"{dart_names[d]} {scene.labels[d]}" for d in map_.darts)
        sentences.append(f"Darts with their letters: {labels}.")
    if scene.ringed is not None:
        sentences.append(f"Ringed is dart {dart_names[scene.ringed]}.")
    end = "" if scene.robot is None else f", the robot is in the end at {dart_names[scene.robot]}"
    sentences.append(f"The start is dart {dart_names[scene.start]}{end}.")
    return " ".join(sentences)


def _edge(scene: Scene, drawn: Layout, dart: Dart) -> Iterator[ET.Element]:
    """The edge, and before it the gaps that it leaves in the edges below."""
    way = drawn.ways[dart]
    for start, end in bridges_of(way):
        yield tag("path", class_="bridge", d=f"M{at(start)} L{at(end)}")
    yield edge_along(scene, dart, curve(way))


def _vertex(scene: Scene, drawn: Layout, vertex: int) -> ET.Element:
    """The vertex with the numbers of its darts, its markers and the robot."""
    darts = scene.map.vertices[vertex]
    along = {dart: drawn.along(dart) for dart in darts}
    arrow = _clockwise([*along.values()])
    return vertex_with(scene, vertex, drawn.vertices[vertex], along, [arrow])


def _clockwise(along: Sequence[complex]) -> ET.Element:
    """An arrow that turns clockwise, in the middle of the widest gap between two darts."""
    angles = sorted(phase(direction) for direction in along)
    gaps = [(b - a, a) for a, b in pairwise([*angles, angles[0] + tau])]
    wide, first = max(gaps, key=lambda gap: round(gap[0], 6))
    half = min(wide / 2 - 0.25, 0.6)
    start, end = (first + wide / 2 + turn for turn in (-half, half))
    tip = TURN * complex(cos(end), sin(end))
    ahead = complex(cos(end + pi / 2), sin(end + pi / 2))
    head = [tip + 5 * ahead, tip - 3j * ahead, tip + 3j * ahead]
    arc = f"M{at(TURN * complex(cos(start), sin(start)))} A{TURN} {TURN} 0 0 1 {at(tip)}"
    return tag(
        "g",
        tag("path", class_="arc", d=arc),
        tag("path", class_="head", d=f"M{' L'.join(map(at, head))} Z"),
        class_="clockwise",
    )
