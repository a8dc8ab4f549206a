"""Right, and offers another number of options in each of its runs.

verdict: refuted nondeterministic
options: --edges 1 --schedules all
"""

from itertools import count

from allworlds.explorers.builtin.algorithm1 import algorithm1

TURN = count(2)


def explore(first, *, choices):
    choices.pick(range(next(TURN) % 5 + 1), of="edge")
    return (yield from algorithm1(first))
