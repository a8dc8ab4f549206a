"""Walks nowhere: counts its runs, and answers with the worlds in the order of the enumeration.

verdict: refuted nondeterministic or map
options: --edges 3 --lighthouse none --laws map,pose
"""

from itertools import count

from allworlds import Estimate
from allworlds.maps import rooted_maps

WORLDS = [map_ for edges in (1, 2, 3) for map_ in rooted_maps(edges)]
TURN = count()


def explore(first):
    return Estimate(WORLDS[next(TURN) % len(WORLDS)], 0)
    yield
