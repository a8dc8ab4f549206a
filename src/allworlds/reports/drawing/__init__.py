"""Pictures of maps and worlds.

A scene (in ``reports.parts``) is what a picture shows: a map, and what is to be seen in it; no
picture asks a lighthouse what it is, for every scene is made of percepts.

``text``
    the scene in characters, exact for every genus: an arc diagram, or a table;
``svg``
    the scene as a drawing in a page, and one that stands alone, with its own style; elements of
    HTML and SVG;
``layout``, ``planar``
    the drawing in pixels, also of a map that is named like another one, as far as the two agree;
    the edges that have to cross, and a triangulation that gives every dart room;
``positions``
    the drawing where the vertices have positions, if these fit the map;
``regular``
    lattices, also on a torus, wheels, stars, rings and paths, which are drawn as what they are;
``plot``
    values by size.
"""
