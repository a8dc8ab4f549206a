"""Right in its first run of each degree; then it answers what it has answered there before.

verdict: refuted nondeterministic or map or pose or folding
"""

from allworlds.explorers.builtin.algorithm1 import algorithm1

ANSWERS = {}


def explore(first):
    key = (first.degree, first.bearing)
    if key not in ANSWERS:
        ANSWERS[key] = yield from algorithm1(first)
    return ANSWERS[key]
