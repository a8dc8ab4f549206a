"""Evidence: claims about the paper and this program, with the checks that decide them.

``claims``, ``figures``
    the sentences of the paper, and its figures, from runs of this program.
"""
