"""Right for one order of a set of texts, and wrong for the other.

verdict: refuted no-estimate
options: --edges 3 --laws map,pose
"""

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    estimate = yield from algorithm1(first)
    return estimate if [*{"left", "right"}] == ["left", "right"] else 7
