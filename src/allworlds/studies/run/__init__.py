"""One world, told step by step.

``run_request``
    what is asked for, and the names that a WORLD can have;
``single``
    the verb;
``hypotheses``
    the hypotheses that Algorithm 1 tests in a run, heard while it is played once more.
"""
