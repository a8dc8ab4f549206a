"""Right in each of its runs, and sets an alarm after each, which ends its idle process.

verdict: holds
"""

import signal

from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first):
    signal.setitimer(signal.ITIMER_REAL, 0)
    answer = yield from algorithm1(first)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    return answer
