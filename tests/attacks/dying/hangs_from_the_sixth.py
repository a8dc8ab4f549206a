"""Right in its first five episodes, and silent for ever in the sixth of each process.

verdict: refuted timeout or nondeterministic
options: --edges 2 --answer-timeout 0.5
"""

from itertools import count

from allworlds.explorers.builtin.algorithm1 import algorithm1

TURN = count(1)


def explore(first):
    while next(TURN) > 5:
        pass
    return (yield from algorithm1(first))
