"""Right, and killed from outside in its very first run, as by a machine without memory.

verdict: holds
quick: 1
"""

import os
import signal
from pathlib import Path

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    if not Path("killed").exists():
        Path("killed").touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return (yield from algorithm1(first))
