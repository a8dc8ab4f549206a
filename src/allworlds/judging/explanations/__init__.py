"""A finding in plain words: the robot's belief, the truth, and the step where they diverge.

``by_law``
    **the** table of the laws, each with the explanation of a run that breaks it;
``advice``, ``endless``
    the causes that the kind of a fault makes likely; a run without an end;
``story``
    the finding with its walk, and that walk in a wrong answer: the input of all explanations; the
    one slip by which a right answer becomes a wrong one.
"""
