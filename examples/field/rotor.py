"""The rotor-router with an adversary: each vertex has a pointer, which goes round.

The robot turns the pointer of its vertex to the next dart clockwise, and leaves by it.  Where the
pointers stand at first is the adversary's choice, made when the robot comes to a vertex for the
first time; ``--schedules all`` tries every one.

Source: V. Priezzhev, D. Dhar, A. Dhar, S. Krishnamurthy, Eulerian walkers as a model of
self-organized criticality (1996); V. Yanovski, I. Wagner, A. Bruckstein, A distributed ant
algorithm for efficiently patrolling a network (2003).

Lighthouse: ``compass+whiteboard``: a pointer is kept as its bearing from the reference dart, plus
1.  Task: ``cover:edges``.  Expected: every edge is walked along within 2m(n-1) + 2m motions, and
within 2md + 2m (tried to 4 edges); 2m is REFUTED, in the smallest case by a map with 3 edges::

    allworlds check rotor.py:rotor --lighthouse compass+whiteboard:states=16 --task cover:edges
        --schedules all --edges 4 --bound '2*m*(n-1) + 2*m'
"""

from allworlds import Move, Write


def rotor(first, *, choices):
    """The explorer; it never ends, and the task ends it."""
    percept = first
    while True:
        degree, north = percept.degree, percept.bearing
        if pointer := percept.marks:
            pointer -= 1
        else:
            pointer = choices.pick(range(degree), of="edge")
        pointer = (pointer + 1) % degree
        yield Write(pointer + 1)
        percept = yield Move(north + pointer)
