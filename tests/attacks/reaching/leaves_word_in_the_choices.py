"""Finds the world in the frames of the first play, and leaves its number among the choices.

The second play would be given the choices; but where there is one schedule a run, the policy
answers them, and not what the first play has said of them.

verdict: refuted map or nondeterministic
options: --edges 3 --lighthouse none --laws map,pose
quick: 1
"""

import sys

from allworlds import Estimate
from allworlds.maps import rooted_maps
from allworlds.world import World

WORLDS = [map_ for edges in (1, 2, 3) for map_ in rooted_maps(edges)]


def explore(first, *, choices):
    picked = choices.pick(range(len(WORLDS)), of="edge")
    frame = sys._getframe()
    while frame := frame.f_back:
        for value in frame.f_locals.values():
            if isinstance(value, World):
                picked = choices.record[0] = WORLDS.index(value.map)
    return Estimate(WORLDS[picked], 0)
    yield
