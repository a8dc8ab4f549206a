"""Keeps more and more, until there is no memory for a run.

verdict: inconclusive
options: --edges 2 --memory 800
"""

from allworlds.explorers.builtin.algorithm1 import algorithm1

KEPT = []


def explore(first):
    KEPT.append(bytearray(1 << 27))
    return (yield from algorithm1(first))
