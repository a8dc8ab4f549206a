"""Pictures of maps and worlds.

``scene``
    what a picture shows: a map, and what is to be seen in it; no picture asks a lighthouse
    what it is, for every scene is made of percepts;
``text``
    the scene in characters, exact for every genus: an arc diagram, or a table;
``svg``
    the scene as a drawing in a page;
``standalone``
    a map or a world as a drawing that stands alone, with its own style;
``layout``, ``mesh``, ``planar``, ``rays``, ``edge_points``
    where its vertices, darts and edges lie: the edges that have to cross, a triangulation that
    gives every dart room, the drawing in pixels, the directions in which edges leave a point,
    and their curves;
``svg_parts``
    what both kinds of drawings are made of;
``alike``
    a map drawn and named like another one, as far as the two agree.
"""
