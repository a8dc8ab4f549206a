"""Right, and spoils the interpreter in which it is: paths, modules, signals, limits, traces.

verdict: holds
options: --edges 1
"""

import gc
import resource
import signal
import sys

from allworlds.explorers.builtin.algorithm1 import algorithm1

sys.path.clear()
for name in ("json", "selectors", "tempfile"):
    sys.modules.pop(name, None)
for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGCHLD):
    signal.signal(number, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_NOFILE, (0, 0))
sys.settrace(lambda *_: None)
sys.setrecursionlimit(200)
gc.disable()


def explore(first):
    return (yield from algorithm1(first))
