"""Kills the process that imports it.

verdict: refused
says: signal 9
"""

import os
import signal

os.kill(os.getpid(), signal.SIGKILL)
