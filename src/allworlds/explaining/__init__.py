"""A finding in plain words: what the robot believed, what was true, and where they part.

``explanation``
    from a finding to an :class:`Explanation`: the entry;
``story``
    the finding with the walk that its log describes, and the names of the places on it;
``belief``, ``parting``
    the same walk in a wrong answer, and the step where the two part, in sentences;
``open_darts``
    what the log leaves open, and how it is in truth, in sentences;
``laws``
    **the** table of the laws: what there is to tell of a run that breaks each of them;
``telling``, ``words``
    what each law hands back, and the small words that all of them use.
"""

from allworlds.explaining.belief import Belief
from allworlds.explaining.explanation import Explanation, explain
from allworlds.explaining.story import Story

__all__ = ["Belief", "Explanation", "Story", "explain"]
