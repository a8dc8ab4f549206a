"""Explanations of findings: the robot's belief, the truth, and the step where both diverge.

``by_law``
    **the** table of the laws, each with the explanation of a run that breaks it;
``advice``, ``endless``
    the likely causes of a kind of fault; sentences about a run without an end;
``story``
    the input of all explanations: the finding with the walk in its world, and with the same walk in
    a wrong answer; also slips: a slip is the single mistake that makes a right answer wrong.
"""
