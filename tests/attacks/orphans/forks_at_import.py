"""Right, and forks when it is imported; both copies go on.

verdict: holds
options: --edges 1
"""

import os

from allworlds.explorers.builtin.algorithm1 import algorithm1

os.fork()


def explore(first):
    return (yield from algorithm1(first))
