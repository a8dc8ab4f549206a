"""Pictures of maps and worlds.

``scene``
    what a picture shows: a map, and what is to be seen in it; no picture asks a lighthouse
    what it is, for every scene is made of percepts;
``text``
    the scene in characters, exact for every genus: an arc diagram, or a table;
``svg``
    the scene as a drawing in a page;
``layout``, ``mesh``, ``planar``, ``rays``, ``spline``
    where its vertices, darts and edges lie: the edges that have to cross, a triangulation that
    gives every dart room, the drawing in pixels, the directions in which edges leave a point,
    and their curves;
``polygon``, ``polygon_svg``
    a map of genus above 0 as a polygon with glued sides, and that as a drawing in a page;
``marks``
    what both kinds of drawings are made of;
``alike``
    a map drawn and named like another one, as far as the two agree.
"""

from allworlds.drawing.alike import extended, layout_like, mirror_of, names_like
from allworlds.drawing.layout import Layout, layout
from allworlds.drawing.polygon import Polygon, polygon
from allworlds.drawing.polygon_svg import has_polygon, polygon_picture
from allworlds.drawing.scene import Names, Scene, scene_of
from allworlds.drawing.svg import in_words, picture
from allworlds.drawing.text import draw, rotation_table

__all__ = [
    "Layout",
    "Names",
    "Polygon",
    "Scene",
    "draw",
    "extended",
    "has_polygon",
    "in_words",
    "layout",
    "layout_like",
    "mirror_of",
    "names_like",
    "picture",
    "polygon",
    "polygon_picture",
    "rotation_table",
    "scene_of",
]
