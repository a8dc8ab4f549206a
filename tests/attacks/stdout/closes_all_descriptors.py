"""Closes all descriptors in its run: nobody hears from it any more.

verdict: refuted crash
options: --edges 1
"""

import os

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    os.closerange(0, 64)
    return (yield from algorithm1(first))
