"""Exact text drawings of maps of any genus, loops and parallel edges included.

The drawing is an arc diagram.  The darts stand in one row that reads as sigma in cycle
notation: each pair of brackets is a vertex with its darts clockwise.  Each edge is an arc
above the row that joins its two darts.  So the map, the names of its darts and the start can
be read back from the picture.  A crossing of two arcs says nothing about the surface.

The order of vertices and darts is fixed by the map rooted at the start: vertices breadth
first, each from the dart by which it is found.  Renaming the darts changes nothing but the
printed numbers.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeVar

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.reports.drawing.scene import Scene

T = TypeVar("T")

LONGEST_ROW = 40
"""Of more vertices in a table, and of more darts of a vertex, both ends are shown."""

_LEGEND = {
    "(": "( ) vertex with its darts clockwise",
    "╭": "╭─╮ edge",
    "→": "a→v.b the other end of dart a is dart b of v",
    "┼": "┼ arcs cross, no vertex",
    "●": "● marker",
    "▲": "▲ dart where the bearing is 0",
    "S": "S start",
    "R": "R robot at the end",
    "a": "a, b, ... under darts: darts with one letter look alike",
}
"""The signs in the order of the legend."""


def draw(scene: Scene, width: int = 80, *, most: int = LONGEST_ROW) -> str:
    """The scene as an arc diagram, or as :func:`rotation_table` where that is wider than ``width``.

    It begins at the start.  Vertex ``v`` is called by its index in ``map.vertices``.  Under the
    darts stand their labels, the names of the vertices with their markers, and the signs of
    single darts.  Lines end in no space, the text in no newline.

    Cost: O(m), and O(m^2) for a diagram, which has less than ``width`` darts.
    """
    map_, labels = scene.map, scene.labels
    groups = _groups(map_, scene.start)
    names_of = _names(scene)
    names = [names_of[map_.vertex_of[group[0]]] for group in groups]
    # Widths follow from the map alone, so that renaming the darts moves nothing.
    cell = max(map(len, [str(len(map_.sigma) - 1), *(labels or ())]))
    column = _columns(groups, cell, names)
    rows = [_darts(groups, column)]
    if labels is not None:
        rows.append(_row({column[dart]: labels[dart] for dart in column}))
    rows.append(_row({column[group[0]]: name for group, name in zip(groups, names, strict=True)}))
    rows += [
        _row({column[dart]: sign for dart in darts})
        for sign, darts in _signed(scene).items()
        if darts
    ]
    if max(map(len, rows)) > width:
        return rotation_table(scene, width, most=most)
    # No arc reaches beyond the darts that it joins.
    arcs = list(_arcs([_span(column[d], column[e]) for d, e in map_.edges]))
    return "\n".join([*arcs, *rows, "", _legend({"(", *"".join(arcs)} | _signs(scene), width)])


def rotation_table(scene: Scene, width: int = 80, *, most: int = LONGEST_ROW) -> str:
    """The scene as a table: a line for each vertex with name, degree and its darts clockwise.

    The order is that of :func:`draw`.  Each dart is written ``dart→vertex.dart``: where its
    edge goes.  The signs stand before the dart, its label in square brackets after it.  Only
    the legend is kept within ``width``.

    Of more than ``most`` vertices, and of more than ``most`` darts of a vertex, the first and
    the last are shown, and how many there are between them.
    """
    map_, labels, signed = scene.map, scene.labels, _signed(scene)
    groups = _groups(map_, scene.start)
    names = _names(scene)
    head, between, tail = _ends(groups, most)

    def entry(dart: Dart) -> str:
        signs = "".join(sign for sign, darts in signed.items() if dart in darts)
        label = "" if labels is None else f"[{labels[dart]}]"
        other = map_.alpha[dart]
        return f"{signs}{dart}{label}→v{map_.vertex_of[other]}.{other}"

    def row(group: list[Dart]) -> list[str]:
        first, left_out, last = _ends(group, most)
        more = [f"({len(left_out):,} darts more)"] if left_out else []
        texts = [*map(entry, first), *more, *map(entry, last)]
        return [names[map_.vertex_of[group[0]]], str(len(group)), *texts]

    rows = [*map(row, head), *map(row, tail)]
    name, degree = (max(len(row[i]) for row in rows) for i in (0, 1))
    cell = max(len(text) for row in rows for text in row[2:])
    lines = [
        "  ".join(
            [row[0].ljust(name), row[1].rjust(degree), *(text.ljust(cell) for text in row[2:])]
        ).rstrip()
        for row in rows
    ]
    if between:
        darts = sum(map(len, between))
        lines.insert(len(head), f"... ({len(between):,} vertices more, with {darts:,} darts)")
    return "\n".join([*lines, "", _legend({"→"} | _signs(scene), width)])


def _signed(scene: Scene) -> dict[str, Sequence[Dart]]:
    """The signs of single darts, each with its darts."""
    robot = () if scene.robot is None else (scene.robot,)
    return {"▲": tuple(scene.pointed), "S": (scene.start,), "R": robot}


def _groups(map_: CombinatorialMap, root: Dart) -> list[list[Dart]]:
    """The vertices breadth first from the root, each clockwise from the dart that found it.

    A vertex finds its neighbours from its last dart back: so the nearer neighbour hangs at
    the dart further right, and the arcs to them nest instead of crossing.
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


def _ends(items: list[T], most: int) -> tuple[list[T], list[T], list[T]]:
    """The first items, those that are left out, and the last ones."""
    if len(items) <= most:
        return items, [], []
    half = most // 2
    return items[:half], items[half : len(items) - half], items[len(items) - half :]


def _turned(map_: CombinatorialMap, first: Dart) -> list[Dart]:
    return [map_.turn(first, offset) for offset in range(map_.degree_at[first])]


def _columns(groups: Sequence[Sequence[Dart]], cell: int, names: Sequence[str]) -> dict[Dart, int]:
    """The column of each dart: cells of one width, brackets round each group, room for names."""
    column = {}
    left = 0
    for group, name in zip(groups, names, strict=True):
        for place, dart in enumerate(group):
            column[dart] = left + 1 + place * (cell + 1)
        left += 1 + max(len(group) * (cell + 1), len(name)) + 1
    return column


def _darts(groups: Sequence[Sequence[Dart]], column: Mapping[Dart, int]) -> str:
    texts = {column[dart]: str(dart) for dart in column}
    for group in groups:
        texts[column[group[0]] - 1] = "("
        texts[column[group[-1]]] += ")"
    return _row(texts)


def _names(scene: Scene) -> list[str]:
    """``v0``, ``v1 ●``, ``v2 ●3``: all names of equal length, then the markers."""
    length = len(f"v{scene.map.vertex_count - 1}")
    names = []
    for vertex in range(scene.map.vertex_count):
        count = scene.marks.get(vertex, 0)
        sign = "" if count == 0 else " ●" if count == 1 else f" ●{count}"
        names.append(f"v{vertex}".ljust(length) + sign)
    return names


def _span(a: int, b: int) -> tuple[int, int]:
    return min(a, b), max(a, b)


def _arcs(spans: Iterable[tuple[int, int]]) -> Iterator[str]:
    """The rows of the arcs, highest first.

    Shorter arcs lie lower, each on the lowest level where it meets no other.  An arc within
    another is then below it, so only arcs whose ends alternate cross, and these once.
    """
    levels: list[list[tuple[int, int]]] = []
    for left, right in sorted(spans, key=lambda span: (span[1] - span[0], span)):
        free = (
            level for level in levels if all(right < other[0] or other[1] < left for other in level)
        )
        level = next(free, None)
        if level is None:
            level = []
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
    parts = []
    length = 0
    for column, text in sorted(texts.items()):
        parts += [" " * (column - length), text]
        length = max(length, column) + len(text)
    return "".join(parts).rstrip()


def _signs(scene: Scene) -> set[str]:
    marked = {"●"} if any(scene.marks.values()) else set()
    lettered = {"a"} if scene.labels is not None else set()
    return marked | lettered | {sign for sign, darts in _signed(scene).items() if darts}


def _legend(signs: set[str], width: int) -> str:
    # Spaces within an item hold together; only between items may the line break.
    items = [text.replace(" ", "\0") for sign, text in _LEGEND.items() if sign in signs]
    lines = textwrap.wrap("   ".join(items), max(width, 1), break_long_words=False)
    return "\n".join(lines).replace("\0", " ")
