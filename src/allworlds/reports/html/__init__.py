"""A report as one page that needs nothing else: no network, no other file, no script to be read.

``page``
    the whole document: the entry;
``findings``, ``walk``
    a finding with its pictures, and its walk as a list of steps;
``svg``
    a map as a picture;
``layout``, ``mesh``, ``planar``
    where its vertices, darts and edges lie: the edges that have to cross, a triangulation that
    gives every dart room, and the drawing in pixels;
``elements``
    how text becomes a document in which nothing of it is markup;
``style.css``, ``script.js``
    what the page looks like, and the keys that step along a walk.
"""

from allworlds.reports.html.page import page

__all__ = ["page"]
