"""The messages between an explorer and the harness: small frozen values, nothing else.

An explorer is a **generator function** ``explore(first)``.  It gets percepts, yields actions
and returns an answer; it never holds a world.  Turning is free and has no action of its own:
it is folded into the next :class:`Move`, or into ``here`` of the answer.

``actions``
    percepts, actions, answers about the world, and the log of a run; an explorer as the harness
    calls it, and what went wrong with one that is no generator;
``choices``
    the choices of an explorer: policies, and every schedule in turn;
``playing``, ``log``
    one run, played to its end, and the log that remains of it;
``turns``
    programs of several robots, asked turn by turn; automata;
``code_lines``
    the lines of the user's code that a play goes through, for findings;
``user_code``, ``importing``
    how code of the user's is named and found; how it is loaded; how a model is called.
"""
