"""Pictures of maps and worlds.

A scene (in ``reports.parts``) is the content of a picture: a map with markers, names and a robot.
The markers in a scene are computed from the percepts at the darts, so the modules here need to know
no kind of lighthouse.

``text``
    the scene in characters, exact for every genus: an arc diagram, or a table;
``svg``
    the scene as a drawing in a page, or as a drawing alone, with its own style; elements of HTML
    and SVG;
``layout``
    the drawing in pixels; of two maps side by side, the second one is drawn like the first, as far
    as the two agree;
``planar``
    a planar drawing with few crossings, and a triangulation that gives every dart room;
``positions``
    the drawing with given positions of the vertices, if these fit the map;
``regular``
    the regular drawings of lattices, also on a torus, of wheels, stars, rings and paths;
``plot``
    curves of values by the size of maps.
"""
