"""Evidence: what is claimed of the paper and of this program, and what decides it.

``claims``, ``figures``
    the sentences of the paper, and its figures, from runs of this program;
``mutants``, ``bench``
    what the checks catch, and what they cost.
"""
