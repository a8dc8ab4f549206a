"""Is wrong, and can be imported three times: once looked at, and in two players.

What they have found is not lost; it is only not confirmed.

verdict: refuted folding
options: --edges 1 --shard 0/2
"""

from pathlib import Path

from allworlds import CombinatorialMap, Estimate

with Path("imported").open("a") as imported:
    imported.write("!")
    if imported.tell() > 3:
        raise RuntimeError("not a fourth time")


def explore(first):
    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield
