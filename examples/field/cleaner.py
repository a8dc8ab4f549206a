"""A robot cleans rooms, depth first: the exercise of interviews, and why one tries every world.

It knows a room again by its number.  When all doors of a room were tried it faces the last one, and
has to turn to the door by which it came, before it goes back.  ``forgets`` does not turn.  In a
grid of rooms that is right from every start: the ways that it takes in place of the way back
happen to lead on.

Source: Robot Room Cleaner, no. 489 of LeetCode; depth first search as of C. P. Trémaux.

Lighthouse: ``labels``.  Task: ``cover``.  Expected: ``cleans`` HOLDS everywhere within 4m motions;
``forgets`` HOLDS in the grid of 4 by 4 rooms from all 48 starts (``grid.json``), and is REFUTED by
the law ``task`` in a world with 3 edges::

    allworlds check cleaner.py:forgets --lighthouse labels --task cover --worlds grid.json
    allworlds check cleaner.py:forgets --lighthouse labels --task cover
"""

from allworlds import Move


def cleaner(*, turns):
    """The robot that turns to the door by which it came, or forgets to."""

    def explore(first):
        clean = {first.marks}

        def visit(doors):
            for _ in range(doors):
                room = yield Move(1)  # the next door
                if room.marks in clean:
                    yield Move(0)  # back by the same door
                else:
                    clean.add(room.marks)
                    yield from visit(room.degree - 1)
                    yield Move(1 if turns else 0)

        yield from visit(first.degree)

    return explore


cleans = cleaner(turns=True)
forgets = cleaner(turns=False)
