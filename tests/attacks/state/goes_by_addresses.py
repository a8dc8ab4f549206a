"""Right, unless its answer is spoiled by the place where an object of its lies in memory.

verdict: refuted nondeterministic or no-estimate
options: --edges 4 --laws map,pose
"""

from allworlds.explorers import algorithm1


def explore(first):
    estimate = yield from algorithm1(first)
    return 7 if id(explore) >> 21 & 3 else estimate
