"""A finding in plain words: what the robot believed, what was true, and where they part.

``explanation``
    from a finding to an :class:`Explanation`: the entry;
``tellers``
    **the** table of the laws, and what there is to tell of a run that breaks each of them;
``parting``
    the step where belief and truth part, and what the log leaves open, in sentences;
``slips``
    the one slip that makes a right answer a wrong one;
``stderr``
    the line of a traceback that tells;
``spending``
    what the traversals were spent on;
``rounds``
    where a walk that comes to no end begins to go round, or finds nothing new;
``another``
    another world that agrees with the log;
``story``
    the finding with its walk, and the same walk in a wrong answer: what tellers are told;
``walked``
    the walk that a log describes, and the names of the places on it.
"""

from allworlds.explaining.explanation import Explanation, explain
from allworlds.explaining.spending import Spending
from allworlds.explaining.story import Belief, Story
from allworlds.explaining.walked import Walked

__all__ = ["Belief", "Explanation", "Spending", "Story", "Walked", "explain"]
