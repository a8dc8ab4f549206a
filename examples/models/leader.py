"""Leader election: robots that are all alike start in one room, and one alone shall lead.

Who finds the board empty writes on it, and leads.  This is right if one acts at a time, and wrong
if two can look at once.

Source: L. Barrière, P. Flocchini, P. Fraigniaud, N. Santoro, Can we elect if we cannot compare?
(2003), for the question; these robots are ours.

    $ allworlds team leader.py:first_one --model leader.py:Election --scheduler central --edges 2
    HOLDS
    $ allworlds team leader.py:first_one --model leader.py:Election --scheduler async --edges 2
    REFUTED
"""

from dataclasses import dataclass

from allworlds import Do
from allworlds.robots import SharedWhiteboard


@dataclass(frozen=True)
class Election(SharedWhiteboard):
    """The model: one robot answers True, all others False."""

    def starts(self, map_, robots):
        """All start at one place."""
        yield (0,) * robots

    def over(self, map_, state):
        """Only answers end a run."""
        return False

    def flaw(self, map_, state, answers):
        """Return what is wrong in the end."""
        return "" if answers.count(True) == 1 else f"{answers.count(True)} robots lead"


def first_one(first):
    """Lead if the board is empty."""
    _, _, board = first
    if board is None:
        yield Do({"write": "taken"})
    return board is None
