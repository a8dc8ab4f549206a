"""Right, and stops the processes that have the same parent: its referee, and other players.

Each is let go on at once by the parent, so that they get through.

verdict of once: holds
verdict of in_every_run: holds
verdict of again_and_again: holds
options: --edges 2 --answer-timeout 3
"""

import os
import signal
import threading
import time
from contextlib import suppress
from pathlib import Path

from allworlds.explorers import algorithm1


def parent_of(process):
    return int((process / "stat").read_text(errors="replace").rpartition(")")[2].split()[1])


def stop_siblings():
    mine = Path("/proc", str(os.getpid()))
    for process in Path("/proc").iterdir():
        if process.name.isdigit() and process != mine:
            with suppress(OSError, IndexError):
                if parent_of(process) == os.getppid():
                    os.kill(int(process.name), signal.SIGSTOP)


def keep_on():
    while True:
        stop_siblings()
        time.sleep(0.01)


def once(first):
    if not Path("stopped").exists():
        Path("stopped").touch()
        stop_siblings()
    return (yield from algorithm1(first))


def in_every_run(first):
    stop_siblings()
    return (yield from algorithm1(first))


def again_and_again(first):
    if threading.active_count() == 1:
        threading.Thread(target=keep_on, daemon=True).start()
    return (yield from algorithm1(first))
