"""Right, and looks for another way to stdout: that of the processes that it comes from.

verdict: holds
options: --edges 1
"""

import os
from contextlib import suppress

from allworlds.explorers import algorithm1


def explore(first):
    for process in (os.getpid(), os.getppid()):
        with suppress(OSError), open(f"/proc/{process}/fd/1", "w") as out:
            out.write("got you\n")
    return (yield from algorithm1(first))
