"""Can be imported once; what cannot be loaded where it is to be played is bad input.

verdict: refused
says: not a second time
"""

from pathlib import Path

from allworlds.explorers.builtin.algorithm1 import algorithm1

if Path("imported").exists():
    raise RuntimeError("not a second time")
Path("imported").touch()


def explore(first):
    return (yield from algorithm1(first))
