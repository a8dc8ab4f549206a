"""Input from outside: checks of values, requests, and the refusal of nested checks.

``checks``
    checks of values, and the error about bad input; guards against users' programs that set the
    exit code of the process, or catch an interrupt by the user (Ctrl-C);
``nesting``
    the refusal of a check that begins inside another check;
``requests``
    requests: the arguments of a verb as one value.
"""
