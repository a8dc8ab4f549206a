"""Right, and starts programs in sessions of their own, one when it is imported.

verdict: holds
options: --edges 1
"""

import subprocess
import sys

from allworlds.explorers.builtin.algorithm1 import algorithm1


def start():
    code = "import time; time.sleep(3600)"
    subprocess.Popen([sys.executable, "-c", code], start_new_session=True, env={})


start()


def explore(first):
    start()
    return (yield from algorithm1(first))
