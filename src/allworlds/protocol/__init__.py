"""The messages between an explorer and its player, which are small frozen values.

An explorer is a **generator function** ``explore(first)``.  It gets percepts, yields actions and
returns an answer; it never holds a world.  No action stands for a turn of the robot at a vertex,
which costs nothing: it is a part of the next :class:`Move`, or of ``here`` in the answer.

``actions``
    percepts, actions, answers about the world, and the log of a run; the interface of explorers,
    and the faults of explorers outside Python;
``choices``
    the choices of an explorer: policies, and every schedule in turn;
``playing``
    the play of one run to its end, which yields a log (see ``allworlds.log``);
``turns``
    programs of several robots, asked turn by turn; automata;
``code_lines``
    the lines of the user's code that run in a play, for findings;
``user_code``, ``importing``
    names and texts of the user's code; loading this code, and calling the models in it.
"""
