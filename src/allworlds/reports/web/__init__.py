"""Web pages, each a single file that needs no network.

``sections``
    the frame of every page; the parts of a report's content as elements of a page, with the steps
    of walks;
``controls.html``
    the buttons with which the reader steps through the pictures of a walk;
``style.css``, ``script.js``, ``fit.js``
    the style of a page, the keys that step along a walk, and the sizes of pictures;
``play``, ``play.html``, ``play.css``
    the page in which the reader is the robot and draws a map from the percepts;
``world.js``
    functions for the robot's motions and percepts in a world;
``robot.js``
    functions for the robot's notes: the map that follows from the percepts so far, and from the
    pairs of darts that the reader takes for one dart;
``spots.js``, ``play.js``
    the positions of the vertices in the reader's map; the game and its buttons.

The functions of ``world.js`` and ``robot.js`` need no page; tests compare their results with the
worlds in Python.
"""
