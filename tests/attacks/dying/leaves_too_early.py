"""Right, but at every tenth run it ends its process.  That it is repeated nowhere is no excuse.

verdict: refuted crash or nondeterministic
options: --edges 3
"""

import os
from itertools import count

from allworlds.explorers.builtin.algorithm1 import algorithm1

TURN = count(1)


def explore(first):
    if next(TURN) % 10 == 0:
        os._exit(0)
    return (yield from algorithm1(first))
