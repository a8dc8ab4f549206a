"""Is wrong, and can be imported five times: looked at, by two players, and in two opposite orders.

What they have found is not lost; it is only not confirmed.

verdict: refuted map
options: --edges 1 --shard 0/2
"""

from pathlib import Path

from allworlds import CombinatorialMap, Estimate

with Path("imported").open("a") as imported:
    imported.write("!")
    if imported.tell() > 5:
        raise RuntimeError("not a sixth time")


def explore(first):
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield
