"""Parts of scene pictures that every form shares."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from xml.etree import ElementTree as ET

from allworlds.maps import Dart
from allworlds.reports.drawing.layout import CHIP, DISC, HIGH, rim
from allworlds.reports.drawing.scene import Scene
from allworlds.reports.markup import Child, tag

FLAG = 12.0
"""The length of the head of the arrow that stands for a marker's direction, in pixels."""

COLOURS = 12
"""The number of classes of darts that have distinct colours."""


def curve(way: Sequence[complex]) -> str:
    """A curve through these points: straight, then a parabola for each point between."""
    path = f"M{at(way[0])} L{at((way[0] + way[1]) / 2)}"
    for towards, after in pairwise(way[1:]):
        path += f" Q{at(towards)} {at((towards + after) / 2)}"
    return f"{path} L{at(way[-1])}"


def edge_along(scene: Scene, dart: Dart, path: str) -> ET.Element:
    """The edge of a dart, drawn along the path from that dart to the other one."""
    other = scene.map.alpha[dart]
    walked = dart in scene.walked or other in scene.walked
    kind = "edge walked" if walked else "edge"
    return tag("path", class_=kind, data_darts=f"{dart} {other}", d=path)


def stub(dart: Dart, start: complex, end: complex) -> ET.Element:
    """The straight beginning of a dart, as a path."""
    return tag("path", class_="stub", data_stub=dart, d=f"M{at(start)} L{at(end)}")


def vertex_with(
    scene: Scene,
    vertex: int,
    centre: complex,
    along: Mapping[Dart, complex],
    below: Sequence[ET.Element] = (),
) -> ET.Element:
    """A vertex with its name, everything that is shown there, and the numbers of some darts.

    Args:
        scene: what is shown.
        vertex: which of its vertices.
        centre: where that is drawn.
        along: for each of the darts the direction in which it leaves there, of length 1.
        below: what lies below all this.
    """
    marks, parts = scene.marks.get(vertex, 0), [*below]
    rims = {
        dart: rim(here, [other for d, other in along.items() if d != dart], _width(scene, dart))
        for dart, here in along.items()
    }
    parts += [flag(along[dart], rims[dart]) for dart in along if dart in scene.pointed]
    parts.append(tag("circle", class_="disc", r=DISC))
    parts.append(tag("text", scene.vertex_names[vertex], class_="name"))
    if marks > 1:
        text = f"\N{MULTIPLICATION SIGN}{marks}"
        parts.append(tag("text", text, class_="marks", x=rounded(DISC), y=rounded(-DISC)))
    parts += [number(scene, dart, rims[dart] * along[dart]) for dart in along]
    return tag(
        "g",
        tag("g", *parts, class_="fixed"),
        class_="vertex marked" if marks else "vertex",
        data_vertex=vertex,
        transform=f"translate({at(centre)})",
    )


def flag(along: complex, far: float) -> ET.Element:
    """The marker's arrow, behind the number of the dart that it points along."""
    base, wing = (far + CHIP) * along, along * 1j * FLAG * 0.55
    head = f"M{at(base + FLAG * along)} L{at(base + wing)} L{at(base - wing)} Z"
    return tag(
        "g",
        tag("path", class_="pole", d=f"M{at(0j)} L{at(base)}"),
        tag("path", class_="flag", d=head),
    )


def number(scene: Scene, dart: Dart, place: complex) -> ET.Element:
    """The dart's number: in a box where the robot started, on a disc where it is."""
    text: list[Child] = [scene.dart_names[dart]]
    colour = ""
    if scene.labels is not None:
        text.append(tag("tspan", scene.labels[dart], class_="letter"))
        colour = f" class-{sorted(set(scene.labels)).index(scene.labels[dart]) % COLOURS}"
    wide, high = _width(scene, dart) + 4, HIGH + 2
    left, top = rounded(-wide / 2), rounded(-high / 2)
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
        transform=f"translate({at(place)})",
    )


def _width(scene: Scene, dart: Dart) -> float:
    """Width in pixels of the dart's number with its letter."""
    letters = "" if scene.labels is None else scene.labels[dart]
    return 4.0 + 7.0 * len(scene.dart_names[dart] + letters)


def at(point: complex) -> str:
    """A point, as written in a path."""
    return f"{rounded(point.real)} {rounded(point.imag)}"


def rounded(value: float) -> str:
    """A coordinate, rounded to a tenth of a pixel."""
    # Adding 0 turns -0 into 0.
    return f"{round(value, 1) + 0.0:.1f}"
