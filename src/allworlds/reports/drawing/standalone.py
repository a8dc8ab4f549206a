"""Drawings that stand alone: in a notebook, in a file, in a paper."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path
from xml.etree import ElementTree as ET

from msgspec import Struct

from allworlds.inputs.checks import InputError, a_path, show
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.reports.drawing.scene import Scene, scene_of
from allworlds.reports.drawing.svg import picture
from allworlds.reports.drawing.text import draw as drawn_in_characters
from allworlds.reports.rendering import tag
from allworlds.words import size
from allworlds.world.world import World

# No variables and no nesting: other programs than browsers read it.  In a notebook the rules of a
# drawing reach the whole page, so that each begins with the name of its drawing.
STYLE = """
#NAME text { font: 600 12px system-ui, sans-serif; fill: #1c2126; text-anchor: middle;
  dominant-baseline: central; }
#NAME .edge { fill: none; stroke: #5a646d; stroke-width: 1.5; }
#NAME .bridge { fill: none; stroke: #ffffff; stroke-width: 11; }
#NAME .stub, #NAME .robot { display: none; }
#NAME .pole { fill: none; stroke: #c26a00; stroke-width: 3; }
#NAME .flag { fill: #c26a00; }
#NAME .disc { fill: #e4eaf0; stroke: #1c2126; stroke-width: 1.5; }
#NAME .marked .disc { fill: #ffe3b0; stroke: #c26a00; stroke-width: 3; }
#NAME .name { font-size: 11px; }
#NAME .arc { fill: none; stroke: #5b646d; stroke-width: 1.3; }
#NAME .head { fill: #5b646d; }
#NAME .dart text { paint-order: stroke; stroke: #ffffff; stroke-width: 4px; }
#NAME .box { fill: none; }
#NAME .start .box { fill: #ffffff; stroke: #1c2126; stroke-width: 1.3; }
#NAME .start text { stroke: none; }
"""


SUFFIX = ".svg"
"""The end of the names of files of drawings."""


class Drawing(Struct, frozen=True):
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
            InputError: if the name of the file does not end in ``.svg``.
            OSError: if it cannot be written.
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
    where = size(map_.edge_count, map_.vertex_count)
    title = f"A {'world' if isinstance(shown, World) else 'map'} with {where}"

    def svg(name: str) -> str:
        root = picture(scene, name, title)
        root.insert(2, tag("style", STYLE.replace("NAME", name)))
        return ET.tostring(root, "unicode") + "\n"

    # In a notebook that shows several drawings, each has a name of its own: that of its content.
    content = svg("map").encode()
    return Drawing(svg(f"map-{sha256(content).hexdigest()[:16]}"), drawn_in_characters(scene))
