"""Is wrong, and sees to it that its process ends with the exit code of success.

verdict: refuted map
"""

import atexit
import os

from allworlds import CombinatorialMap, Estimate

atexit.register(os._exit, 0)


def explore(first):
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield
