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
    gives every dart room, and the drawing in pixels.
"""

from allworlds.drawing.layout import Layout, layout
from allworlds.drawing.scene import Scene, scene_of
from allworlds.drawing.svg import in_words, picture
from allworlds.drawing.text import draw, rotation_table

__all__ = ["Layout", "Scene", "draw", "in_words", "layout", "picture", "rotation_table", "scene_of"]
