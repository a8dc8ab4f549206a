"""Right, and called as a module of Python's.

verdict: holds
"""

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    return (yield from algorithm1(first))
