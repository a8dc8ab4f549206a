"""Is wrong, and can be imported four times: looked at, by two players, and under one seed more.

What they have found is not lost; it is only not confirmed.

verdict: refuted folding
options: --edges 1 --shard 0/2
"""

from pathlib import Path

from allworlds import CombinatorialMap, Estimate

with Path("imported").open("a") as imported:
    imported.write("!")
    if imported.tell() > 4:
        raise RuntimeError("not a fifth time")


def explore(first):
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield
