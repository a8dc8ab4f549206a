"""Exact text drawings of maps of any genus, loops and parallel edges included.

The drawing is an arc diagram.  The darts stand in one row that reads as sigma in cycle
notation: each pair of brackets is a vertex with its darts clockwise.  Each edge is an arc
above the row that joins its two darts.  So the map, the names of its darts and the start can
be read back from the picture.  A crossing of two arcs says nothing about the surface.

Below the row *signs* stand under some darts, such as ``S`` under the start.  A legend tells what
each sign in the picture means.

The order of vertices and darts is fixed by the map rooted at the start: vertices breadth
first, each from the dart by which it is found.  If the darts are renamed, only the printed numbers
change.
"""

import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.reports.parts import Scene

LONGEST_ROW = 40
"""The largest number of vertices in a table, and of darts of a vertex, that are all shown."""

LONGEST_NAME = 16
"""The largest number of characters of a vertex's name in a picture; the legend explains names that
are cut."""

_LEGEND = {
    "(": "( ) vertex with its darts clockwise",
    "╭": "╭─╮ edge",
    "→": "a→v.b the other end of dart a is dart b of v",
    "┼": "┼ arcs cross, no vertex",
    "●": "● marker",
    "●k": "●k a robot that comes in by this dart senses k marks",
    "▲": "▲ dart where the bearing is 0",
    "S": "S start",
    "R": "R robot at the end",
    "a": "a, b, ... under darts: darts with the same letter look alike",
}
"""The signs, each with its meaning, in the order of the legend."""


def draw(scene: Scene, width: int = 80) -> str:
    """The scene as an arc diagram; if it is wider than ``width``, as a :func:`rotation_table`.

    The diagram begins at the start.  Below the darts there are three kinds of lines: first the text
    that ``scene.labels`` has for each dart; then the names of the vertices, with their markers;
    then the signs that :func:`_signed` lists.  A vertex without a name is called ``v`` and its
    index in ``map.vertices``.  Lines do not end with a space, and the text does not end with a
    newline.

    Cost: O(m) for a table, O(m^2) for a diagram.
    """
    map_, labels = scene.map, scene.labels
    groups = _groups(map_, scene.root)
    names_of = _names(scene)
    names = {group[0]: names_of[map_.vertex_of[group[0]]] for group in groups}
    # Widths follow from the map alone, so that renaming the darts moves nothing.
    cell = max(map(len, [str(len(map_.sigma) - 1), *(labels or ())]))
    column, texts, left = dict[Dart, int](), dict[int, str](), 0
    for group in groups:
        column |= {dart: left + 1 + i * (cell + 1) for i, dart in enumerate(group)}
        texts |= {left: "(", **{column[dart]: str(dart) for dart in group}}
        texts[column[group[-1]]] += ")"
        left += 1 + max(len(group) * (cell + 1), len(names[group[0]])) + 1
    rows = [texts]
    if labels is not None:
        rows.append({at: labels[dart] for dart, at in column.items()})
    rows.append({column[dart]: name for dart, name in names.items()})
    rows += [{column[dart]: sign for dart in darts} for sign, darts in _signed(scene).items()]
    lines = [line for line in map(_row, rows) if line]
    if max(map(len, lines)) > width:
        return rotation_table(scene, width)
    # No arc reaches beyond the darts that it joins.
    arcs = list(
        _arcs((min(column[d], column[e]), max(column[d], column[e])) for d, e in map_.edges)
    )
    return "\n".join([*arcs, *lines, "", _legend({"(", *"".join(arcs)}, scene, width)])


def rotation_table(scene: Scene, width: int = 80) -> str:
    """The scene as a table: a line for each vertex with name, degree and its darts clockwise.

    The order is that of :func:`draw`.  Each dart is written ``dart→vertex.dart``, with the other
    end of its edge.  The signs of a dart stand before it; the text that ``scene.labels`` has for
    the dart stands after it, in square brackets.  The rows may be wider than ``width``; only the
    legend is wrapped to this width.

    If there are more than :data:`LONGEST_ROW` vertices, or darts of a vertex, the first and the
    last of them are shown, with the number of those between.
    """
    map_, labels, signed = scene.map, scene.labels, _signed(scene)
    names, shown = _names(scene), scene.short_names(LONGEST_NAME)

    def entry(dart: Dart) -> str:
        signs = "".join(sign for sign, darts in signed.items() if dart in darts)
        label = "" if labels is None else f"[{labels[dart]}]"
        other = map_.alpha[dart]
        return f"{signs}{dart}{label}→{shown[map_.vertex_of[other]]}.{other}"

    rows = []
    for group in _groups(map_, scene.root):
        darts = _cut([*map(entry, group)], "darts")
        rows.append([names[map_.vertex_of[group[0]]], str(len(group)), *darts])
    name, degree = (max(len(row[i]) for row in rows) for i in (0, 1))
    cell = max(len(text) for row in rows for text in row[2:])
    lines = [
        "  ".join([v.ljust(name), d.rjust(degree), *(text.ljust(cell) for text in texts)]).rstrip()
        for v, d, *texts in rows
    ]
    lines = _cut(lines, "vertices")
    return "\n".join([*lines, "", _legend({"→"}, scene, width)])


def _signed(scene: Scene) -> dict[str, Sequence[Dart]]:
    """For each sign that a dart can have, the darts that have this sign.

    The signs are ``●k`` (the robot senses k marks if it arrives by this dart), ``▲`` (pointed),
    ``S`` (start) and ``R`` (robot).
    """
    start, robot = (() if d is None else (d,) for d in (scene.start, scene.robot))
    marked: dict[str, Sequence[Dart]] = {
        f"●{marks}": [dart for dart, its in scene.letters.items() if its == marks]
        for marks in sorted(set(scene.letters.values()))
    }
    return {**marked, "▲": tuple(scene.pointed), "S": start, "R": robot}


def _groups(map_: CombinatorialMap, root: Dart) -> list[list[Dart]]:
    """The darts of each vertex, clockwise from the dart by which the vertex is found.

    The vertices are in the order in which a breadth-first search from ``root`` finds them.  At each
    vertex the search follows the last dart of the group first.  So the vertex at the other end of
    the last dart comes next in the drawing, and the arcs from one vertex are nested and do not
    cross.
    """
    found = {map_.vertex_of[root]}
    groups = [_turned(map_, root)]
    for group in groups:
        for dart in reversed(group):
            other = map_.alpha[dart]
            if map_.vertex_of[other] not in found:
                found.add(map_.vertex_of[other])
                groups.append(_turned(map_, other))
    return groups


def _cut(texts: list[str], what: str) -> list[str]:
    """The texts; if there are more than :data:`LONGEST_ROW`, only the first and the last ones.

    The number of left out texts stands between them, with the noun ``what``.
    """
    if len(texts) <= LONGEST_ROW:
        return texts
    half = LONGEST_ROW // 2
    return [*texts[:half], f"... ({len(texts) - 2 * half:,} {what} more)", *texts[-half:]]


def _turned(map_: CombinatorialMap, first: Dart) -> list[Dart]:
    return [map_.turn(first, offset) for offset in range(map_.degree_at[first])]


def _names(scene: Scene) -> list[str]:
    """The name of each vertex with its markers: ``v0``, ``v1 ●``, ``v2 ●3``."""
    length = 0 if scene.vertices else len(f"v{scene.map.vertex_count - 1}")
    names = []
    for vertex, name in enumerate(scene.short_names(LONGEST_NAME)):
        count = scene.marks.get(vertex, 0)
        sign = "" if count == 0 else " ●" if count == 1 else f" ●{count}"
        names.append(name.ljust(length) + sign)
    return names


def _arcs(spans: Iterable[tuple[int, int]]) -> Iterator[str]:
    """The rows of the arcs, the highest first; ``spans`` holds the columns of the ends of each arc.

    Shorter arcs are lower, each on the lowest level without an overlap.  So an arc is above every
    arc inside it; only arcs whose ends alternate cross, and they cross once.
    """
    levels: list[list[tuple[int, int]]] = []
    for left, right in sorted(spans, key=lambda span: (span[1] - span[0], span)):
        free = (
            level for level in levels if all(right < other[0] or other[1] < left for other in level)
        )
        level = next(free, [])
        if not level:
            levels.append(level)
        level.append((left, right))
    legs: set[int] = set()
    for level in reversed(levels):
        signs = dict.fromkeys(legs, "│")
        for left, right in level:
            for x in range(left + 1, right):
                signs[x] = "┼" if x in legs else "─"
            signs[left], signs[right] = "╭", "╮"
        yield _row(signs)
        legs.update(x for span in level for x in span)


def _row(texts: Mapping[int, str]) -> str:
    """A line with each text at its column, and no space at its end."""
    line = ""
    for column, text in sorted(texts.items()):
        line = line.ljust(column) + text
    return line.rstrip()


def _legend(signs: set[str], scene: Scene, width: int) -> str:
    """The legend of a picture: the meaning of each sign in it, and the whole names that were cut.

    ``signs`` are the brackets, arcs or arrows that the picture is drawn with.  The function adds
    the signs for markers, for texts below darts and for single darts, if the scene has such things.
    A long name of a vertex is cut in the picture; the legend has this name whole.
    """
    signs |= {"●"} if any(scene.marks.values()) else set()
    signs |= {"a"} if scene.labels is not None else set()
    signs |= {sign for sign, darts in _signed(scene).items() if darts}
    signs |= {"●k"} if scene.letters else set()
    # Spaces within an item hold together; only between items may the line break.
    said = [text for sign, text in _LEGEND.items() if sign in signs]
    items = [text.replace(" ", "\0") for text in [*said, *scene.cut_names(LONGEST_NAME)]]
    lines = textwrap.wrap("   ".join(items), max(width, 1), break_long_words=False)
    return "\n".join(lines).replace("\0", " ")
