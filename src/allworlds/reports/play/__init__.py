"""A page in which the reader is the robot: percepts come, motions go, and a map is drawn of them.

``page``
    the document: the entry;
``robot.js``
    what a robot does and senses, and what it concludes: it knows nothing of pages, and is held
    against the worlds in Python;
``view.js``, ``play.css``
    what is seen of it, and what can be clicked.
"""
