"""Right, and called as a package of ours.

verdict: holds
"""

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    return (yield from algorithm1(first))
