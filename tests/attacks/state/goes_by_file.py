"""Counts its runs in a file, which both plays find, and goes another way in each.

verdict: refuted nondeterministic
options: --edges 2 --laws map,pose
"""

from pathlib import Path
from random import Random

from allworlds import Move
from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    with Path("runs").open("a") as runs:
        runs.write("another\n")
        draw = Random(runs.tell())
    for _ in range(12):
        there = draw.randrange(2)
        for step in (there, 0, -there, 0):
            yield Move(step)
    return (yield from algorithm1(first))
