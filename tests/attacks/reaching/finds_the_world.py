"""Walks the frames of its callers, finds the world there, and answers with it.

The second play has no world to be found.

verdict: refuted nondeterministic or crash
options: --edges 2 --lighthouse none --laws map,pose
"""

import sys

from allworlds import Estimate
from allworlds.world import World


def explore(first):
    frame = sys._getframe()
    while frame := frame.f_back:
        for value in frame.f_locals.values():
            if isinstance(value, World):
                return Estimate(value.map, value.start)
    raise LookupError("no world")
    yield
