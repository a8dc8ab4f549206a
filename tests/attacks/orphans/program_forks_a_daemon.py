"""A program that leaves a daemon behind, which holds its output open, and dies.

as: exec
verdict: refuted crash
options: --edges 1
"""

import os
import time

if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        time.sleep(3600)
    os._exit(0)
os._exit(3)
