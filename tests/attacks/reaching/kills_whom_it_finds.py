"""Right, but in its first run it kills its parent, the guardian; nothing is said of it then.

verdict: inconclusive
"""

import os
import signal
from pathlib import Path

from allworlds.explorers import algorithm1


def explore(first):
    if not Path("killed").exists():
        Path("killed").touch()
        os.kill(os.getppid(), signal.SIGKILL)
    return (yield from algorithm1(first))
