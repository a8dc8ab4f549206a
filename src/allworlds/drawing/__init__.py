"""Pictures of maps and worlds.

``scene``
    what a picture shows: a map, and what is to be seen in it; no picture asks a lighthouse
    what it is, for every scene is made of percepts;
``text``
    the scene in characters, exact for every genus: an arc diagram, or a table;
``svg``
    the scene as a drawing in a page;
``layout``, ``mesh``, ``planar``
    where its vertices, darts and edges lie: the edges that have to cross, a triangulation that
    gives every dart room, and the drawing in pixels;
``alike``
    a map drawn and named like another one, as far as the two agree.
"""

from allworlds.drawing.alike import extended, layout_like, mirror_of, names_like
from allworlds.drawing.layout import Layout, layout
from allworlds.drawing.scene import Names, Scene, scene_of
from allworlds.drawing.svg import in_words, picture
from allworlds.drawing.text import draw, rotation_table

__all__ = [
    "Layout",
    "Names",
    "Scene",
    "draw",
    "extended",
    "in_words",
    "layout",
    "layout_like",
    "mirror_of",
    "names_like",
    "picture",
    "rotation_table",
    "scene_of",
]
