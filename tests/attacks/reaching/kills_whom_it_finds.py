"""Right, but in its first run it kills its parent, the guardian; an honest check says what it saw.

verdict: internal
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
