"""Elements of HTML and SVG, and the picture of a map as SVG, in a page or alone."""

import json
import re
from cmath import phase
from collections.abc import Iterator, Sequence
from hashlib import sha256
from importlib.resources import files
from itertools import pairwise
from math import cos, pi, sin, tau
from pathlib import Path
from typing import TypeAlias
from xml.etree import ElementTree as ET

from msgspec import Struct

from allworlds.inputs.checks import InputError, a_path, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.reports.drawing.layout import CHIP, DISC, HIGH, Layout, bridges_of, rim
from allworlds.reports.drawing.positions import laid_out
from allworlds.reports.drawing.text import draw as drawn_in_characters
from allworlds.reports.parts import LONGEST_IN_LEGEND, Scene, scene_of
from allworlds.words import escaped, harmless_json, size
from allworlds.world.world import World

Child: TypeAlias = ET.Element | str
"""A child of an element: another element, or a text."""

# HTML allows neither control characters nor non-characters, and UTF-8 no half of a pair.
_FORBIDDEN = re.compile(
    "[^\t\n\r\x20-\x7e\xa0-\ud7ff\ue000-\ufdcf\ufdf0-\ufffd\U00010000-\U0010ffff]"
    f"|[{''.join(chr(plane << 16 | low) for plane in range(1, 17) for low in (0xFFFE, 0xFFFF))}]"
)
_INLINE = frozenset(
    {"a", "b", "bdi", "code", "button", "span", "title", "td", "th", "dt", "text", "tspan"}
)


def tag(name: str, /, *children: Child, **attributes: str | float | None) -> ET.Element:
    """An element with its children.

    Each keyword argument is an attribute of the element.  An attribute that is None is left out.  A
    ``_`` at the end of the argument's name is dropped, so ``class_``, for example, is written for
    the attribute ``class``, whose name is a keyword of Python.  Any other ``_`` in the name becomes
    a ``-``.

    A newline follows the element, unless the element stands inside a line of text.
    """
    element = ET.Element(name)
    for key, value in attributes.items():
        if value is not None:
            element.set(key.rstrip("_").replace("_", "-"), legal(escaped(str(value))))
    for child in children:
        if isinstance(child, ET.Element):
            element.append(child)
        elif len(element):
            element[-1].tail = (element[-1].tail or "") + legal(escaped(child))
        else:
            element.text = (element.text or "") + legal(escaped(child))
    if name not in _INLINE:
        element.tail = "\n"
    return element


def record(document: object, /, **attributes: str) -> ET.Element:
    """A ``script`` element that holds a JSON document as data, for the scripts of the page.

    The signs ``<``, ``>`` and ``&`` of the document are escaped, so no text in the document can end
    the element.  ``attributes`` are further attributes of the element.
    """
    text = harmless_json(json.dumps(document, indent=1))
    for sign in "<>&":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return raw("script", text, type="application/json", **attributes)


def raw(name: str, text: str, /, **attributes: str) -> ET.Element:
    """A ``script`` or ``style`` element, whose text a browser reads unescaped."""
    if "</" in text or "<!--" in text:
        raise ValueError(f"the text of a {name} would end it")
    element = tag(name, **attributes)
    element.text = text
    return element


def legal(text: str) -> str:
    """The text with a replacement for each character that HTML does not allow."""
    return _FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", text)


def document(root: ET.Element) -> str:
    """The text of the page with this root element."""
    return "<!DOCTYPE html>\n" + ET.tostring(root, "unicode", method="html") + "\n"


FLAG = 12.0
"""The length of the head of the arrow that stands for a marker's direction, in pixels."""

COLOURS = 12
"""The number of classes of darts that have distinct colours."""


def at(point: complex) -> str:
    """The text for a point in a path of SVG."""
    return f"{rounded(point.real)} {rounded(point.imag)}"


def rounded(value: float) -> str:
    """A coordinate, rounded to a tenth of a pixel."""
    # Adding 0 turns -0 into 0.
    return f"{round(value, 1) + 0.0:.1f}"


LETTER = 9.0
"""The distance from the end of a cut edge to the middle of its letter, in pixels."""

MARGIN = 30.0
"""The margin of the drawing, in pixels."""

SHORT = 5
"""The largest number of characters of a name that is written into a vertex's disc; longer names are
beside the disc."""

BESIDE, BEYOND, WIDE = 31.0, 42.0, 7
"""In pixels: the distance from a vertex to a name beside it, the distance to a name that is beyond
a dart's number, and the width of a character."""

STEEP = 0.8
"""The sine of the angle to the horizontal above which a dart runs through its vertex's name."""

TURN = 16.5
"""The radius, in pixels, of the arrow that shows the clockwise direction."""


def picture(scene: Scene, name: str, title: str, drawn: Layout | None = None) -> ET.Element:
    """The scene as an SVG element; ``name`` is its id, ``title`` the text for screen readers.

    ``drawn`` is the scene's layout, by default that of :func:`laid_out`.
    """
    map_ = scene.map
    drawn = drawn or laid_out(scene)
    left, top, width, height = (round(x) for x in drawn.box(MARGIN))
    names = scene.short_names(LONGEST_IN_LEGEND)
    # A name beside a disc may lie outside of the drawing.
    sides = [len(name) * WIDE // 2 if len(name) > SHORT else 0 for name in names]
    across = [round(vertex.real) for vertex in drawn.vertices]
    right = max(left + width, *(x + side for x, side in zip(across, sides, strict=True)))
    left = min(left, *(x - side for x, side in zip(across, sides, strict=True)))
    more = round(BEYOND + LETTER - MARGIN) if any(sides) else 0
    return tag(
        "svg",
        tag("title", title, id=f"{name}-title"),
        tag("desc", in_words(scene), id=f"{name}-desc"),
        *(part for dart, _ in map_.edges for part in _edge(scene, drawn, dart)),
        *(
            # The straight beginning of the dart.
            tag("path", class_="stub", data_stub=d, d=f"M{at(way[0])} L{at(drawn.stub(d))}")
            for d, way in enumerate(drawn.ways)
        ),
        *(_vertex(scene, drawn, v, name) for v, name in enumerate(names)),
        tag("g", class_="arrows"),
        id=name,
        class_="map",
        role="img",
        aria_labelledby=f"{name}-title {name}-desc",
        viewBox=f"{left} {top - more} {right - left} {height + 2 * more}",
        width=right - left,
        height=height + 2 * more,
        xmlns="http://www.w3.org/2000/svg",
    )


def in_words(scene: Scene) -> str:
    """The scene in words, for readers who cannot see it."""
    map_, darts, vertices = scene.map, scene.dart_names, scene.vertex_names
    sentences = []
    for vertex, around in enumerate(map_.vertices):
        ends = ((dart, map_.alpha[dart]) for dart in around)
        ways = (
            f"{darts[dart]} to dart {darts[end]} of {vertices[map_.vertex_of[end]]}"
            for dart, end in ends
        )
        sentences.append(f"Clockwise round {vertices[vertex]} its darts lead: {', '.join(ways)}.")
    sentences += [f"Markers at {vertices[v]}: {marks}." for v, marks in sorted(scene.marks.items())]
    if scene.letters:
        marks = ", ".join(f"{k} by {darts[d]}" for d, k in sorted(scene.letters.items()))
        sentences.append(f"Marks that are sensed by single darts: {marks}.")
    if scene.pointed:
        sentences.append(f"Pointed darts: {', '.join(darts[d] for d in sorted(scene.pointed))}.")
    if scene.labels is not None:
        letters = ", ".join(map(" ".join, zip(darts, scene.labels, strict=True)))
        sentences.append(f"Darts with their letters: {letters}.")
    if scene.ringed is not None:
        sentences.append(f"Ringed is dart {darts[scene.ringed]}.")
    end = "" if scene.robot is None else f", the robot is in the end at {darts[scene.robot]}"
    if scene.start is not None:
        sentences.append(f"The start is dart {darts[scene.start]}{end}.")
    return " ".join(sentences)


def _edge(scene: Scene, drawn: Layout, dart: Dart) -> Iterator[ET.Element]:
    """The elements of the edge to which ``dart`` belongs.

    The edges of a map are drawn one after another.  At each crossing, the edge that is drawn later
    goes over the earlier one: before its own line, a bridge is drawn, a short piece in the colour
    of the paper, which makes a gap in the line of the earlier edge.  Each edge has a bridge at each
    of its crossings, though the bridge covers nothing if the other edge is not drawn yet.
    """
    other = scene.map.alpha[dart]
    walked = dart in scene.walked or other in scene.walked
    kind, darts = "edge walked" if walked else "edge", f"{dart} {other}"
    pieces = drawn.pieces(dart, other)
    for way in pieces:
        for start, end in bridges_of(way):
            yield tag("path", class_="bridge", d=f"M{at(start)} L{at(end)}")
        # Straight, then a parabola for each point between.
        path = f"M{at(way[0])} L{at((way[0] + way[1]) / 2)}"
        for towards, after in pairwise(way[1:]):
            path += f" Q{at(towards)} {at((towards + after) / 2)}"
        yield tag("path", class_=kind, data_darts=darts, d=f"{path} L{at(way[-1])}")
    if len(pieces) > 1:
        for end in (dart, other):
            spot = drawn.ways[end][-1] + LETTER * drawn.along(end)
            letter = tag("text", drawn.letters[end], class_="cut fixed")
            yield tag("g", letter, data_cut=darts, transform=f"translate({at(spot)})")


def _vertex(scene: Scene, drawn: Layout, vertex: int, name: str) -> ET.Element:
    """The vertex with its name, the numbers of its darts, its markers and the robot."""
    marks = scene.marks.get(vertex, 0)
    along = {dart: drawn.along(dart) for dart in scene.map.vertices[vertex]}
    rims = {
        dart: rim(here, [other for d, other in along.items() if d != dart], _width(scene, dart))
        for dart, here in along.items()
    }
    parts = [_clockwise([*along.values()])]
    parts += [_flag(along[dart], rims[dart]) for dart in along if dart in scene.pointed]
    parts.append(tag("circle", class_="disc", r=DISC))
    if len(name) > SHORT:
        parts.append(tag("text", name, class_="name beside", y=_beside([*along.values()])))
    else:
        # In whatever font: a longer name is as wide as the disc.
        fit = 2 * DISC if len(name) > 3 else None
        adjust = fit and "spacingAndGlyphs"
        parts.append(tag("text", name, class_="name", textLength=fit, lengthAdjust=adjust))
    if marks > 1:
        text = f"\N{MULTIPLICATION SIGN}{marks}"
        parts.append(tag("text", text, class_="marks", x=rounded(DISC), y=rounded(-DISC)))
    parts += [_number(scene, dart, rims[dart] * along[dart]) for dart in along]
    return tag(
        "g",
        tag("g", *parts, class_="fixed"),
        class_="vertex marked" if marks else "vertex",
        data_vertex=vertex,
        transform=f"translate({at(drawn.vertices[vertex])})",
    )


def _beside(along: Sequence[complex]) -> float:
    """The distance from a vertex down to its name; it is negative if the name is above the vertex.

    ``along`` holds the directions of the vertex's darts, whose numbers the name must not touch.
    """
    down, up = (any(side * way.imag > STEEP for way in along) for side in (1, -1))
    far = BEYOND if down and up else BESIDE
    return -far if down and not up else far


def _flag(along: complex, far: float) -> ET.Element:
    """The arrow of a marker, from the vertex along a dart; its head is beyond the dart's number.

    ``along`` is the direction of the dart, ``far`` the distance from the vertex to the number.
    """
    base, wing = (far + CHIP) * along, along * 1j * FLAG * 0.55
    head = f"M{at(base + FLAG * along)} L{at(base + wing)} L{at(base - wing)} Z"
    return tag(
        "g",
        tag("path", class_="pole", d=f"M{at(0j)} L{at(base)}"),
        tag("path", class_="flag", d=head),
    )


def _number(scene: Scene, dart: Dart, point: complex) -> ET.Element:
    """The dart's number, with the dart's label and marks, centred at ``point``.

    The start dart has its number in a box, the robot's dart on a disc.
    """
    text: list[Child] = [scene.dart_names[dart]]
    colour = ""
    if scene.labels is not None:
        text.append(tag("tspan", scene.labels[dart], class_="letter"))
        colour = f" class-{sorted(set(scene.labels)).index(scene.labels[dart]) % COLOURS}"
    if dart in scene.letters:
        text.append(tag("tspan", f"●{scene.letters[dart]}", class_="letter"))
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
        transform=f"translate({at(point)})",
    )


def _width(scene: Scene, dart: Dart) -> float:
    """The width in pixels of the text at a dart: its name, and its letter and marks if any.

    The letter is the text in ``scene.labels``.  The marks are the number in ``scene.letters``,
    which is there if the number of marks that the robot senses depends on the dart of arrival.
    """
    letters = "" if scene.labels is None else scene.labels[dart]
    marks = f"●{scene.letters[dart]}" if dart in scene.letters else ""
    return 4.0 + 7.0 * len(scene.dart_names[dart] + letters + marks)


def _clockwise(along: Sequence[complex]) -> ET.Element:
    """An arrow round a vertex that shows the clockwise direction.

    ``along`` holds the directions of the vertex's darts.  The arrow is in the middle of the widest
    gap between two of these darts.
    """
    # Rounded: the last bits differ between machines, and must not choose between equal gaps.
    angles = sorted(round(phase(each) + pi, 6) % round(tau, 6) - pi for each in along)
    gaps = [(b - a, a) for a, b in pairwise([*angles, angles[0] + tau])]
    wide, first = max(gaps, key=lambda gap: round(gap[0], 4))
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


SUFFIX = ".svg"
"""The suffix of the files of drawings."""


class Drawing(Struct, frozen=True):
    """A picture of a map or a world.

    Attributes:
        svg: an SVG document with its own style.
        text: the same picture in characters.
    """

    svg: str
    text: str

    def save(self, file: str | Path) -> None:
        """Write the SVG document into a file.

        Raises:
            InputError: if the name of the file does not end in ``.svg``.
            OSError: if the file cannot be written.
        """
        path = a_path("file", file)
        if path.suffix.lower() != SUFFIX:
            raise InputError(
                f"file {show(str(file))} does not end in {SUFFIX}: a drawing is written as SVG"
            )
        path.write_text(self.svg, encoding="utf-8")

    def __str__(self) -> str:
        return self.text

    def _repr_svg_(self) -> str:
        """The SVG document, which notebooks show as a picture."""
        return self.svg


def draw(shown: CombinatorialMap | World) -> Drawing:
    """A picture of a map or a world; for equal maps or worlds it is the same each time.

    Args:
        shown: the map or the world.  In the picture of a world, its lighthouse and its start are
            drawn, too.

    Raises:
        InputError: if ``shown`` is neither a map nor a world.
    """
    if not isinstance(shown, CombinatorialMap | World):
        raise InputError(f"{show(shown)} is neither a CombinatorialMap nor a World")
    scene = scene_of(shown) if isinstance(shown, World) else Scene(shown)
    where = size(scene.map.edge_count, scene.map.vertex_count)
    title = f"A {'world' if isinstance(shown, World) else 'map'} with {where}"
    return drawing(scene, title)


def drawing(scene: Scene, title: str) -> Drawing:
    """The picture of a scene alone, outside of a page; ``title`` is the text for screen readers."""
    style = (files("allworlds.reports.drawing") / "alone.css").read_text(encoding="utf-8")

    def svg(name: str) -> str:
        root = picture(scene, name, title)
        root.insert(2, tag("style", style.replace("NAME", name)))
        return ET.tostring(root, "unicode") + "\n"

    # In a notebook that shows several drawings, each has a name of its own: that of its content.
    content = svg("map").encode()
    return Drawing(svg(f"map-{sha256(content).hexdigest()[:16]}"), drawn_in_characters(scene))
