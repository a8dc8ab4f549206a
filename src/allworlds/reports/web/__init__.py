"""Web pages, each a single file that needs no network.

``sections``, ``controls.html``
    the parts of a report's content as elements, with the steps of walks; the frame of every page,
    and the controls of pictures that can be stepped through;
``style.css``, ``script.js``, ``fit.js``
    the style of a page, the keys that step along a walk, and the sizes of pictures;
``play``, ``play.html``, ``play.css``
    the page in which the reader is the robot and draws a map from the percepts;
``world.js``, ``robot.js``
    the robot's motions and percepts, and the robot's conclusions, as functions that need no page;
    tests compare their results with the worlds in Python;
``spots.js``, ``play.js``
    the positions of the vertices in the reader's map; the game and its buttons.
"""
