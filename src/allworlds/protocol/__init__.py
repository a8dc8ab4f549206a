"""The messages between an explorer and its player, which are small frozen values.

An explorer is a **generator function** ``explore(first)``.  It gets percepts, yields actions and
returns an answer; it never holds a world.  The robot turns at a vertex without an action and at no
cost: the next :class:`Move` tells by which dart the robot leaves, and ``here`` in the answer tells
at which dart it stands.

``actions``
    percepts, actions, answers about the world, and the log of a run; the interface of explorers,
    and the faults of explorers outside Python;
``choices``
    the choices of an explorer: policies, and every schedule, one after another;
``playing``
    the play of one run to its end, which yields a log (see ``allworlds.log``);
``turns``
    programs of several robots, asked for one action after each percept; automata;
``code_lines``
    the lines of the user's code that run in a play, for findings;
``user_code``, ``importing``
    names and texts of the user's code; loading this code, and calling the models in it.
"""
