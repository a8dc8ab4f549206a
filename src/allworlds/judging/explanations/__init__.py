"""A finding in plain words: the robot's belief, the truth, and the step where they diverge.

``explanation``
    from a finding to an :class:`~allworlds.judging.Explanation`: the entry;
``by_law``
    **the** table of the laws, each with the explanation of a run that breaks it;
``wrong_pose``
    the explanation of the law ``pose``;
``parting``
    the step where belief and truth diverge, and the open darts of the log, in sentences;
``slips``
    the one slip by which a right answer becomes a wrong one;
``traceback_line``
    the line of a traceback with the error;
``spending``
    the purposes of the traversals;
``whose_bound``
    the owner of the exceeded bound, and the way to check without it;
``rounds``
    the step where an endless walk begins to go round, or to find no new edge;
``another_world``
    another world that agrees with the log;
``story``
    the finding with its walk, and that walk in a wrong answer: the input of all explanations;
``named_walk``
    the walk that a log describes, and the names of the places on it.
"""
