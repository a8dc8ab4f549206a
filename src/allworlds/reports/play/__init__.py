"""A page in which the reader is the robot and draws a map from the percepts.

``page``
    the document: the entry;
``robot.js``
    what a robot does and senses, and what it concludes: it knows nothing of pages, and is held
    against the worlds in Python;
``spots.js``
    where the places of the notes are drawn: each stays there;
``view.js``, ``play.css``
    what is seen of it, and what can be clicked.
"""
