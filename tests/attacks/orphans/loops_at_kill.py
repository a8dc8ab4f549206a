"""Runs for ever, and who checks it gets SIGKILL.

verdict: -9
signal: SIGKILL
quick: 1
"""

from pathlib import Path


def explore(first):
    Path("ready").touch()
    while True:
        pass
    yield
