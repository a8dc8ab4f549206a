"""The parts of a web page that shows a telling, complete in itself: no network, no other file.

``sections``
    each part of a telling as elements;
``frame``
    what every page has round it;
``viewer``, ``walk``, ``cost_plot``
    pictures to step through, a walk as a list of steps, and cost against bound;
``beside``, ``known``
    pictures of two maps side by side, and of what an explorer knows beside its world;
``style.css``, ``script.js``
    what a page looks like, and the keys that step along a walk.
"""
