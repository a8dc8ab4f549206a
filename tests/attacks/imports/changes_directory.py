"""Right, and goes to another directory, when it is imported and in each run.

verdict: holds
options: --edges 1
"""

import os

from allworlds.explorers.builtin.algorithm1 import algorithm1

os.chdir("/")


def explore(first):
    os.chdir("/tmp")
    return (yield from algorithm1(first))
