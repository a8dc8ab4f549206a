"""A program that leaves a daemon behind, which holds its output open, and ends: it is silent.

as: exec
verdict: refuted timeout
options: --edges 1 --answer-timeout 1
"""

import os
import time

if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        time.sleep(3600)
    os._exit(0)
os._exit(3)
