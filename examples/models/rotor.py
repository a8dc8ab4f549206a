"""Rotor-router: each room has a pointer to a door, which goes round.

Each time the robot leaves, it turns the pointer of the room to the next door, and goes there.

Source: V. Yanovski, I. A. Wagner, A. M. Bruckstein, A distributed ant algorithm for efficiently
patrolling a network, Algorithmica 37(3), 165-186 (2003).

    $ allworlds check rotor.py --lighthouse compass+whiteboard:states=8 --task cover:edges --bound '2*m*n' --edges 3
    HOLDS
    $ allworlds check rotor.py --lighthouse compass+whiteboard:states=8 --task cover:edges --bound '2*m' --edges 4
    REFUTED
"""

from allworlds import Move, Write


def rotor(first):
    """Walk for ever; the task ends the run."""
    percept = first
    while True:
        pointer = (percept.marks + 1) % percept.degree
        yield Write(pointer)
        percept = yield Move(percept.bearing + pointer)
