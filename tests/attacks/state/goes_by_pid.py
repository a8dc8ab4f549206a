"""Right, but which way it goes first depends on the number of its process.

verdict: refuted nondeterministic
options: --edges 2 --laws map,pose
"""

import os
from random import Random

from allworlds import Move
from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    draw = Random(os.getpid())
    for _ in range(12):
        there = draw.randrange(2)
        for step in (there, 0, -there, 0):
            yield Move(step)
    return (yield from algorithm1(first))
