"""Right, and writes to stdout in every way, when it is imported, in its runs, and at its end.

verdict: holds
options: --edges 1
quick: 1
"""

import atexit
import os
import sys
import threading
import time

from allworlds.explorers.builtin.algorithm1 import algorithm1


def write():
    print("printed")
    sys.__stdout__.write("written\n")
    os.write(1, b"to the descriptor\n")
    os.system("echo by a shell")


def go_on():
    while True:
        print("by a thread")
        time.sleep(0.01)


write()
atexit.register(write)
threading.Thread(target=go_on, daemon=True).start()


def explore(first):
    write()
    return (yield from algorithm1(first))
