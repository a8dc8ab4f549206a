"""Right, and goes by the hash of a text, which differs from process to process.

verdict: holds
options: --edges 2 --laws map,pose
quick: 1
"""

from allworlds import Move
from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    for digit in f"{hash(str(first)) % 2**12:b}":
        for step in (int(digit), 0, -int(digit), 0):
            yield Move(step)
    return (yield from algorithm1(first))
