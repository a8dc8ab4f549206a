"""Wrong but for its first schedule, and takes what it has chosen out of the record.

verdict: refuted nondeterministic
options: --edges 2 --schedules all
"""

from allworlds import CombinatorialMap, Estimate
from allworlds.explorers import algorithm1


def explore(first, *, choices):
    picked = choices.pick([0, 1], of="edge")
    choices.record.clear()
    if picked:
        return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    return (yield from algorithm1(first))
