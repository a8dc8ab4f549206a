"""A scene as a drawing in a page: the darts leave each vertex in their cyclic order, clockwise.

The labels of a scene are not drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from xml.etree import ElementTree as ET

from allworlds.drawing.layout import Layout, layout
from allworlds.drawing.scene import Scene
from allworlds.maps.combinatorial import Dart
from allworlds.markup import Child, tag

DISC, ROBOT, MARGIN = 12.0, 6.0, 26.0
"""In pixels: the radii of a vertex and of a robot, and the free room round the drawing."""

FLAG = 12.0
"""The length of the head of the arrow that stands for a marker's direction, in pixels."""


def picture(scene: Scene, name: str, title: str) -> ET.Element:
    """The scene as an SVG element; ``name`` is its id, ``title`` what a screen reader says."""
    map_, drawn = scene.map, layout(scene.map, scene.start)
    left, top, width, height = (round(x) for x in drawn.box(MARGIN))
    return tag(
        "svg",
        tag("title", title, id=f"{name}-title"),
        tag("desc", in_words(scene), id=f"{name}-desc"),
        *(_edge(scene, drawn, dart) for dart, _ in map_.edges),
        *(_dart(scene, drawn, dart) for dart in map_.darts),
        *(_vertex(scene, drawn, vertex) for vertex in range(map_.vertex_count)),
        *(_number(scene, drawn, dart) for dart in map_.darts),
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
    map_ = scene.map
    sentences = []
    for vertex, darts in enumerate(map_.vertices):
        ways = [
            f"{dart} to dart {map_.alpha[dart]} of v{map_.vertex_of[map_.alpha[dart]]}"
            for dart in darts
        ]
        sentences.append(f"Clockwise round v{vertex} its darts lead: {', '.join(ways)}.")
    for vertex, marks in sorted(scene.marks.items()):
        sentences.append(f"Markers at v{vertex}: {marks}.")
    if scene.pointed:
        sentences.append(f"Pointed darts: {', '.join(map(str, sorted(scene.pointed)))}.")
    end = "" if scene.robot is None else f", the robot is in the end at {scene.robot}"
    sentences.append(f"The start is dart {scene.start}{end}.")
    return " ".join(sentences)


def _edge(scene: Scene, drawn: Layout, dart: Dart) -> ET.Element:
    other = scene.map.alpha[dart]
    walked = dart in scene.walked or other in scene.walked
    return tag(
        "path",
        class_="edge walked" if walked else "edge",
        data_darts=f"{dart} {other}",
        d=_curve(drawn.ways[dart]),
    )


def _curve(way: Sequence[complex]) -> str:
    """From the first point to the last: straight, then a parabola for each point between."""
    path = f"M{_at(way[0])} L{_at((way[0] + way[1]) / 2)}"
    for towards, after in pairwise(way[1:]):
        path += f" Q{_at(towards)} {_at((towards + after) / 2)}"
    return f"{path} L{_at(way[-1])}"


def _dart(scene: Scene, drawn: Layout, dart: Dart) -> ET.Element:
    """The beginning of the dart, the marker's arrow if it points along it, and the robot's seat."""
    centre, stub = drawn.ways[dart][0], drawn.stub(dart)
    along = (stub - centre) / abs(stub - centre)
    parts = [tag("path", class_="stub", d=f"M{_at(centre)} L{_at(stub)}")]
    if dart in scene.pointed:
        base, wing = centre + (DISC + FLAG) * along, along * 1j * FLAG * 0.55
        head = f"M{_at(base + FLAG * along)} L{_at(base + wing)} L{_at(base - wing)} Z"
        parts.append(tag("path", class_="pole", d=f"M{_at(centre)} L{_at(base)}"))
        parts.append(tag("path", class_="flag", d=head))
    seat = centre + (DISC + ROBOT) * along
    parts.append(tag("circle", class_="robot", cx=_x(seat), cy=_y(seat), r=ROBOT))
    here = " here" if dart == scene.robot else ""
    return tag("g", *parts, class_=f"dart{here}", data_dart=dart)


def _vertex(scene: Scene, drawn: Layout, vertex: int) -> ET.Element:
    centre, marks = drawn.vertices[vertex], scene.marks.get(vertex, 0)
    parts: list[Child] = [
        tag("circle", cx=_x(centre), cy=_y(centre), r=DISC),
        tag("text", f"v{vertex}", x=_x(centre), y=_y(centre)),
    ]
    if marks > 1:
        badge = centre + DISC * (0.8 - 0.8j)
        parts.append(
            tag("text", f"\N{MULTIPLICATION SIGN}{marks}", class_="marks", x=_x(badge), y=_y(badge))
        )
    return tag("g", *parts, class_="vertex marked" if marks else "vertex", data_vertex=vertex)


def _number(scene: Scene, drawn: Layout, dart: Dart) -> ET.Element:
    """The dart's number, in a box where the robot started."""
    at = drawn.label(dart)
    text = tag("text", str(dart), x=_x(at), y=_y(at))
    if dart != scene.start:
        return tag("g", text, class_="number")
    wide, high = 10.0 + 6.0 * len(str(dart)), 16.0
    box = tag("rect", x=_x(at - wide / 2), y=_y(at - 1j * high / 2), width=wide, height=high, rx=3)
    return tag("g", box, text, class_="number start")


def _at(point: complex) -> str:
    return f"{_x(point)} {_y(point)}"


def _x(point: complex) -> str:
    return _rounded(point.real)


def _y(point: complex) -> str:
    return _rounded(point.imag)


def _rounded(value: float) -> str:
    # Adding 0 turns -0 into 0.
    return f"{round(value, 1) + 0.0:.1f}"
