"""Explanations of findings: the robot's belief, the truth, and the step where they diverge.

``by_law``
    **the** table of the laws, each with the explanation of a run that breaks it;
``advice``, ``endless``
    the likely causes of a kind of fault; sentences about a run without an end;
``story``
    the input of all explanations, which is the finding with its walk, and the same walk in a wrong
    answer; the one slip that turns a right answer into a wrong one.
"""
