"""A finding in plain words: what the robot believed, what was true, and where they part.

``explanation``
    from a finding to an :class:`~allworlds.judging.Explanation`: the entry;
``by_law``
    **the** table of the laws, and what there is to tell of a run that breaks each of them;
``parting``
    the step where belief and truth part, and what the log leaves open, in sentences;
``slips``
    the one slip that makes a right answer a wrong one;
``traceback_line``
    the line of a traceback that tells;
``spending``
    what the traversals were spent on;
``rounds``
    where a walk that comes to no end begins to go round, or finds nothing new;
``another_world``
    another world that agrees with the log;
``story``
    the finding with its walk, and the same walk in a wrong answer: what tellers are told;
``named_walk``
    the walk that a log describes, and the names of the places on it.
"""
