"""Maps on axes of matplotlib: the darts leave each vertex in their cyclic order, clockwise."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

from msgspec import Struct, field

from allworlds import CombinatorialMap
from allworlds.claims import layout

INK, FAINT, PAPER = "#1a1a1a", "#c9c9c9", "white"
"""Colours of known parts, of unknown parts, and of the ground."""

RADIUS = 9.0
"""Of a vertex, in the units of a layout."""


class Canvas(Struct, frozen=True):
    """A map that is being drawn.

    Attributes:
        axes: of matplotlib.
        map: what is drawn.
        layout: where it lies, as ``layout`` gives it.
        name: ``map-0`` in the first axes of a figure.  A file has the path of each edge, and of
            the beginning of each dart, under an id, ``map-0-edge-3`` and ``map-0-dart-3``.
    """

    axes: Any
    map: CombinatorialMap
    layout: Any
    name: str
    _named: set[str] = field(default_factory=set)

    @classmethod
    def of(cls, axes: Any, map_: CombinatorialMap, root: int) -> Canvas:
        """Return empty axes with room for the map; y grows downwards, as in a layout."""
        drawn = layout(map_, root)
        left, top, width, height = drawn.box(24)
        axes.set(xlim=(left, left + width), ylim=(top + height, top), aspect="equal")
        axes.set_axis_off()
        return cls(axes, map_, drawn, f"map-{axes.figure.axes.index(axes)}")

    def edges(self, darts: Iterable[int], **style: Any) -> None:
        """Draw the edges of these darts, each from end to end."""
        for dart in darts:
            for way in self.layout.pieces(dart, self.map.alpha[dart]):
                self._path(way, gid=self._id(f"edge-{dart}"), **style)

    def stubs(self, darts: Iterable[int], **style: Any) -> None:
        """Draw the beginnings of these darts."""
        for dart in darts:
            start, end = self.layout.ways[dart][0], self.layout.stub(dart)
            xs, ys = zip(*(_xy(point) for point in (start, end)), strict=True)
            self.axes.plot(xs, ys, gid=self._id(f"dart-{dart}"), **style)

    def vertices(self, vertices: Iterable[int], *, fill: str, ink: str = INK) -> None:
        """Draw these vertices with their names."""
        from matplotlib.patches import Circle

        for vertex in vertices:
            centre = _xy(self.layout.vertices[vertex])
            self.axes.add_patch(Circle(centre, RADIUS, facecolor=fill, edgecolor=ink, zorder=4))
            text = PAPER if fill == INK else ink
            self.axes.text(
                *centre, f"v{vertex}", color=text, ha="center", va="center", fontsize=7, zorder=5
            )

    def pointer(self, dart: int) -> None:
        """Draw the arrow of a marker that points along the dart."""
        start, end = self.layout.ways[dart][0], self.layout.stub(dart)
        along = (end - start) / abs(end - start)
        tip, tail = _xy(start + along * (RADIUS + 22)), _xy(start + along * RADIUS)
        arrow = {"arrowstyle": "-|>", "color": INK, "linewidth": 2, "mutation_scale": 9}
        arrow |= {"shrinkA": 0, "shrinkB": 0}
        self.axes.annotate("", xy=tip, xytext=tail, arrowprops=arrow, zorder=6)

    def note(self, dart: int, text: str, **style: Any) -> None:
        """Write a short text on the dart's edge, near its vertex."""
        box = {"boxstyle": "round,pad=0.15", "facecolor": PAPER, "edgecolor": "none"}
        a, b, c, *_ = self.layout.ways[dart]
        at = _xy((a + 6 * b + c) / 8)
        self.axes.text(*at, text, ha="center", va="center", fontsize=7, bbox=box, zorder=7, **style)

    def _id(self, what: str) -> str | None:
        """The id of a path; None if another one has it, drawn below."""
        if what in self._named:
            return None
        self._named.add(what)
        return f"{self.name}-{what}"

    def _path(self, way: Sequence[complex], **style: Any) -> None:
        """The path of an edge: straight, then a parabola for each point between, then straight."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        points, codes = [way[0], (way[0] + way[1]) / 2], [Path.MOVETO, Path.LINETO]
        for towards, after in pairwise(way[1:]):
            points += [towards, (towards + after) / 2]
            codes += [Path.CURVE3, Path.CURVE3]
        points.append(way[-1])
        codes.append(Path.LINETO)
        path = Path([_xy(point) for point in points], codes)
        self.axes.add_patch(PathPatch(path, fill=False, **style))


def _xy(point: complex) -> tuple[float, float]:
    return point.real, point.imag
