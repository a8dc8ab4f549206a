"""An explorer that makes no motion: it counts its runs for each degree of the first percept.

Its answers are the worlds that begin with that degree, in the order of the enumeration.

verdict: refuted nondeterministic or map
options: --edges 2 --lighthouse none --laws map,pose
"""

from collections import Counter

from allworlds import Estimate
from allworlds.maps import rooted_maps

WORLDS = [map_ for edges in (1, 2) for map_ in rooted_maps(edges)]
TURN = Counter()


def explore(first):
    worlds = [map_ for map_ in WORLDS if map_.degrees[0] == first.degree]
    TURN[first.degree] += 1
    return Estimate(worlds[(TURN[first.degree] - 1) % len(worlds)], 0)
    yield
