"""Labelled rooms: each has a number of its own, and no door has one.

Depth first: the robot turns back where a door leads into a known room, and counts the rooms.

Source: P. Panaite, A. Pelc, Exploring unknown undirected graphs, Journal of Algorithms 33, 281-295
(1999).

    $ allworlds check labels.py --lighthouse labels --task count:n --bound '4*m' --edges 4
    HOLDS
    $ allworlds check labels.py --lighthouse labels --task count:n --bound '2*m' --edges 4
    REFUTED
"""

from allworlds import Move


def explore(first):
    """Count the rooms."""
    known = {first.marks}

    def visit(doors):
        for _ in range(doors):
            room = yield Move(1)
            if room.marks in known:
                yield Move(0)
            else:
                known.add(room.marks)
                yield from visit(room.degree - 1)
                yield Move(1)  # the last door: the one that it came in by

    yield from visit(first.degree)
    return len(known)
