"""Right, and asked to end from outside in its very first run.

verdict: holds
"""

import os
import signal
from pathlib import Path

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    if not Path("ended").exists():
        Path("ended").touch()
        os.kill(os.getpid(), signal.SIGTERM)
    return (yield from algorithm1(first))
