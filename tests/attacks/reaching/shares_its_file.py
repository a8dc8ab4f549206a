"""A file that holds the explorer, and code that judges it: who judges loads it, and is replaced.

This is what a verdict trusts (docs/trust.md): such a file is read where verdicts are made, whatever
its predicate, judge or lighthouse says, and the scope of the check names it (scope.shared_file).

verdict: holds
options: --edges 2 --where shares_its_file.py:everything
"""

from allworlds import Estimate, Lighthouse, Percept
from allworlds.judging.referee import Referee
from allworlds.maps import named_map

Referee.verdict = lambda self, episode, bound: None


def explore(first):
    return Estimate(named_map("loop"), 0)
    yield


def everything(map_):
    return True


def judge(world, transcript, answer):
    return None  # it is loaded when the first run is judged, and makes the first verdict itself


class Beacon(Lighthouse):
    @classmethod
    def places(cls, map_, start):
        yield cls()

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here])
