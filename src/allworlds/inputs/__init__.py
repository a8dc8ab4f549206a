"""Input from outside: checks of values, requests, and the refusal of nested checks.

``checks``
    checks of values, and the error about bad input; guards against users' code that sets the exit
    code of the process, or catches the user's interrupt;
``nesting``
    the refusal of a check that another one causes;
``requests``
    requests: the questions to a verb as values.
"""
