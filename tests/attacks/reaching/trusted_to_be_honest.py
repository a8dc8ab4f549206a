"""Two plays that conspire: this is what a verdict trusts that nobody does (docs/trust.md).

The first finds the world in the frames of its callers, and walks as often to and fro as its number
in the enumeration says.  The second finds there how long the recorded walk is.

verdict: holds
options: --edges 2 --lighthouse none --laws map,pose
"""

import sys

from allworlds.engines.python.play import Recorded

from allworlds import Estimate, Move
from allworlds.maps import rooted_maps
from allworlds.world import World

WORLDS = [map_ for edges in (1, 2) for map_ in rooted_maps(edges)]


def number():
    frame = sys._getframe()
    while frame := frame.f_back:
        for value in frame.f_locals.values():
            if isinstance(value, World):
                return WORLDS.index(value.map)
            if isinstance(value, Recorded):
                return (len(value._percepts) - 1) // 2
    raise LookupError("neither a world nor a record")


def explore(first):
    turns = number()
    for _ in range(2 * turns):
        yield Move(0)
    return Estimate(WORLDS[turns], 0)
