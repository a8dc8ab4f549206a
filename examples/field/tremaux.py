"""Trémaux's way through a maze: depth first, with marks on the passages.

On the board of a vertex stands which passages were used, and by which one the robot came first.  A
new passage that leads to a vertex with a mark is left at once by the way one came; where all
passages are used the robot goes back by the first one.

Source: É.  Lucas, Récréations mathématiques I (1882), after C. P. Trémaux.

Lighthouse: ``compass+whiteboard``: a passage is known by its bearing from the reference dart.
Task: ``home``.  Expected: ``tremaux`` HOLDS everywhere within 2m motions; 2m - 1 is REFUTED by the
maps with one edge.  ``hasty`` goes on from an old vertex where it should turn back, and is REFUTED,
by the law ``task`` in the smallest case with 3 edges::

    allworlds check tremaux.py:tremaux --lighthouse compass+whiteboard:states=65536 --task home
        --bound '2*m'
"""

from allworlds import Move, Write


def by_marks(*, turns_back):
    """The explorer that turns back where a new passage leads to an old vertex, or goes on."""

    def explore(first):
        percept, arrived = first, None  # the passage by which the robot came, None at the start
        while True:
            degree, north = percept.degree, percept.bearing
            here = -north % degree
            used, way_back = divmod(percept.marks, degree + 2)
            new = way_back == 0  # else it is 1 at the start, and 2 more than the passage
            if new:
                way_back = 1 if arrived is None else here + 2
            fresh = arrived is not None and not used >> here & 1
            if fresh:
                used |= 1 << here
            left = [k for k in range(degree) if not used >> k & 1]
            if fresh and not new and turns_back:
                out = here
            elif left:
                out = left[0]
            elif way_back == 1:
                return
            else:
                out = way_back - 2
            yield Write((used | 1 << out) * (degree + 2) + way_back)
            arrived, percept = out, (yield Move(north + out))

    return explore


tremaux = by_marks(turns_back=True)
hasty = by_marks(turns_back=False)
