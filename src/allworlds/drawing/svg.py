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

from allworlds.drawing.layout import CHIP, DISC, HIGH, Layout, layout
from allworlds.drawing.scene import Scene
from allworlds.maps.combinatorial import Dart
from allworlds.markup import Child, tag

MARGIN = 30.0
"""The free room round the drawing, in pixels."""

FLAG = 12.0
"""The length of the head of the arrow that stands for a marker's direction, in pixels."""

TURN = 16.5
"""The radius of the arrow that shows which way is clockwise."""

COLOURS = 12
"""So many classes of darts have colours of their own, one after the other."""


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
        *(_stub(drawn, dart) for dart in map_.darts),
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
    """The scene for those who do not see it."""
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
    other, way = scene.map.alpha[dart], drawn.ways[dart]
    for bridge in _bridges(way):
        yield tag("path", class_="bridge", d=bridge)
    walked = dart in scene.walked or other in scene.walked
    yield tag(
        "path",
        class_="edge walked" if walked else "edge",
        data_darts=f"{dart} {other}",
        d=_curve(way),
    )


def _bridges(way: Sequence[complex]) -> Iterator[str]:
    """The pieces of the curve about each of its crossings: every third point is one."""
    for k in range(3, len(way) - 3, 3):
        before, at, after = way[k - 1 : k + 2]
        start, end = (before + 3 * at) / 4, (at * 3 + after) / 4
        # The middle half of the parabola from half way before to half way after the crossing.
        middle = (before + 6 * at + after) / 8
        yield f"M{_at((start + middle) / 2)} Q{_at(middle)} {_at((end + middle) / 2)}"


def _curve(way: Sequence[complex]) -> str:
    """From the first point to the last: straight, then a parabola for each point between."""
    path = f"M{_at(way[0])} L{_at((way[0] + way[1]) / 2)}"
    for towards, after in pairwise(way[1:]):
        path += f" Q{_at(towards)} {_at((towards + after) / 2)}"
    return f"{path} L{_at(way[-1])}"


def _stub(drawn: Layout, dart: Dart) -> ET.Element:
    """The straight beginning of the dart."""
    d = f"M{_at(drawn.ways[dart][0])} L{_at(drawn.stub(dart))}"
    return tag("path", class_="stub", data_stub=dart, d=d)


def _vertex(scene: Scene, drawn: Layout, vertex: int) -> ET.Element:
    """The vertex with its darts' numbers round it, and all that is to be seen there."""
    darts, marks = scene.map.vertices[vertex], scene.marks.get(vertex, 0)
    along = {dart: drawn.along(dart) for dart in darts}
    parts: list[ET.Element] = [_clockwise([*along.values()])]
    rim = {dart: drawn.rim(dart, _width(scene, dart)) for dart in darts}
    parts += [_flag(along[dart], rim[dart]) for dart in darts if dart in scene.pointed]
    parts.append(tag("circle", class_="disc", r=DISC))
    parts.append(tag("text", scene.vertex_names[vertex], class_="name"))
    if marks > 1:
        text = f"\N{MULTIPLICATION SIGN}{marks}"
        parts.append(tag("text", text, class_="marks", x=_rounded(DISC), y=_rounded(-DISC)))
    parts += [_number(scene, dart, rim[dart] * along[dart]) for dart in darts]
    return tag(
        "g",
        tag("g", *parts, class_="fixed"),
        class_="vertex marked" if marks else "vertex",
        data_vertex=vertex,
        transform=f"translate({_at(drawn.vertices[vertex])})",
    )


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
    arc = f"M{_at(TURN * complex(cos(start), sin(start)))} A{TURN} {TURN} 0 0 1 {_at(tip)}"
    return tag(
        "g",
        tag("path", class_="arc", d=arc),
        tag("path", class_="head", d=f"M{' L'.join(map(_at, head))} Z"),
        class_="clockwise",
    )


def _flag(along: complex, rim: float) -> ET.Element:
    """The marker's arrow, behind the number of the dart that it points along."""
    base, wing = (rim + CHIP) * along, along * 1j * FLAG * 0.55
    head = f"M{_at(base + FLAG * along)} L{_at(base + wing)} L{_at(base - wing)} Z"
    return tag(
        "g",
        tag("path", class_="pole", d=f"M{_at(0j)} L{_at(base)}"),
        tag("path", class_="flag", d=head),
    )


def _number(scene: Scene, dart: Dart, at: complex) -> ET.Element:
    """The dart's number: in a box where the robot started, on a disc where it is."""
    text: list[Child] = [scene.dart_names[dart]]
    colour = ""
    if scene.labels is not None:
        text.append(tag("tspan", scene.labels[dart], class_="letter"))
        colour = f" class-{sorted(set(scene.labels)).index(scene.labels[dart]) % COLOURS}"
    wide, high = _width(scene, dart) + 4, HIGH + 2
    left, top = _rounded(-wide / 2), _rounded(-high / 2)
    box = tag("rect", class_="box", x=left, y=top, width=wide, height=high, rx=3)
    parts = [tag("circle", class_="ring", r=CHIP + 4)] if dart == scene.ringed else []
    here = " here" if dart == scene.robot else ""
    start = " start" if dart == scene.start else ""
    return tag(
        "g",
        *parts,
        box,
        tag("circle", class_="robot", r=CHIP),
        tag("text", *text),
        class_=f"dart{start}{colour}{here}",
        data_dart=dart,
        transform=f"translate({_at(at)})",
    )


def _width(scene: Scene, dart: Dart) -> float:
    """Of the dart's number with its letter, in pixels."""
    letters = "" if scene.labels is None else scene.labels[dart]
    return 4.0 + 7.0 * len(scene.dart_names[dart] + letters)


def _at(point: complex) -> str:
    return f"{_rounded(point.real)} {_rounded(point.imag)}"


def _rounded(value: float) -> str:
    # Adding 0 turns -0 into 0.
    return f"{round(value, 1) + 0.0:.1f}"
