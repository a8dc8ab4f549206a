"""Drawings that stand alone: in a notebook, in a file, in a paper."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

from allworlds.inputs import InputError, show
from allworlds.maps import CombinatorialMap
from allworlds.reports.drawing.scene import Scene, scene_of
from allworlds.reports.drawing.svg import picture
from allworlds.reports.drawing.text import draw as drawn_in_characters
from allworlds.reports.markup import tag
from allworlds.world import World, code_of

# No variables, no nesting, and no rule for what is outside: other programs than browsers read it,
# and in a notebook it must not colour what stands beside it.
STYLE = """
.map text { font: 600 12px system-ui, sans-serif; fill: #1c2126; text-anchor: middle;
  dominant-baseline: central; }
.map .edge { fill: none; stroke: #5a646d; stroke-width: 1.5; }
.map .bridge { fill: none; stroke: #ffffff; stroke-width: 11; }
.map .stub, .map .robot { display: none; }
.map .pole { fill: none; stroke: #c26a00; stroke-width: 3; }
.map .flag { fill: #c26a00; }
.map .disc { fill: #e4eaf0; stroke: #1c2126; stroke-width: 1.5; }
.map .marked .disc { fill: #ffe3b0; stroke: #c26a00; stroke-width: 3; }
.map .name { font-size: 11px; }
.map .arc { fill: none; stroke: #5b646d; stroke-width: 1.3; }
.map .head { fill: #5b646d; }
.map .dart text { paint-order: stroke; stroke: #ffffff; stroke-width: 4px; }
.map .box { fill: none; }
.map .start .box { fill: #ffffff; stroke: #1c2126; stroke-width: 1.3; }
.map .start text { stroke: none; }
"""


@dataclass(frozen=True, slots=True)
class Drawing:
    """A picture of a map or a world.

    Attributes:
        svg: an SVG document with its own style.
        text: the same in characters.
    """

    svg: str
    text: str

    def save(self, file: str | Path) -> None:
        """Write the SVG document into a file.

        Raises:
            OSError: if it cannot be written.
        """
        Path(file).write_text(self.svg, encoding="utf-8")

    def __str__(self) -> str:
        return self.text

    def _repr_svg_(self) -> str:
        """The picture that notebooks show."""
        return self.svg


def draw(shown: CombinatorialMap | World) -> Drawing:
    """A picture of a map or a world, the same every time.

    Args:
        shown: the map, or the world, whose lighthouse and start are drawn, too.

    Raises:
        InputError: for anything else.
    """
    match shown:
        case World():
            scene, map_ = scene_of(shown), shown.map
        case CombinatorialMap():
            scene, map_ = Scene(shown), shown
        case _:
            raise InputError(f"{show(shown)} is neither a CombinatorialMap nor a World")
    # Names of elements must differ in a notebook that shows several maps.
    name = f"map-{code_of(map_, scene.start)}".translate({ord("/"): "-", ord("."): "_"})
    title = f"A map with {map_.edge_count} edges and {map_.vertex_count} vertices"
    root = picture(scene, name[:80], title)
    root.insert(2, tag("style", STYLE))
    return Drawing(ET.tostring(root, "unicode") + "\n", drawn_in_characters(scene))
