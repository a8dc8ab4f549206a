"""Right, and leaves a daemon behind in each run: forked twice, in a session of its own.

verdict: holds
options: --edges 1
"""

import os
import time

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            os.closerange(0, 64)
            while True:
                time.sleep(1)
        os._exit(0)
    os.wait()
    return (yield from algorithm1(first))
