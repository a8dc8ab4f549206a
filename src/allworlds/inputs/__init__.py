"""Input from outside: checks of values, requests, and the refusal of nested checks.

``checks``
    checks of values, and the error about bad input; guards against users' code that sets the exit
    code of the process, or catches the user's interrupt;
``nesting``
    the refusal of a check that begins inside another check;
``requests``
    requests: the arguments of a verb as one value.
"""
