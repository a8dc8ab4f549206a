"""Is wrong, and sends SIGINT to its whole group.

verdict: refuted map
"""

import os
import signal

from allworlds import CombinatorialMap, Estimate


def explore(first):
    os.kill(0, signal.SIGINT)
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield
