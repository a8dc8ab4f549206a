"""Runs for ever, and who checks it gets SIGHUP.

verdict: 130
signal: SIGHUP
"""

from pathlib import Path


def explore(first):
    Path("ready").touch()
    while True:
        pass
    yield
