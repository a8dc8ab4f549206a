"""Web pages, each complete in itself: no network, no other file.

``sections``, ``controls.html``
    each part of a report's content as elements, and the list of the steps of a walk; what every
    page has round it, and pictures to step through;
``style.css``, ``script.js``, ``fit.js``
    what a page looks like, the keys that step along a walk, and room for pictures;
``play``, ``play.html``, ``play.css``
    the page in which the reader is the robot and draws a map from the percepts;
``world.js``, ``robot.js``
    what a robot does and senses, and what it concludes: they know nothing of pages, and are held
    against the worlds in Python;
``spots.js``, ``play.js``
    where the places of the notes are drawn; what the game shows, and its buttons.
"""
