"""Input from outside: checks of values, and requests.

``checks``
    checks of values, and the error that is the user's to mend; what keeps a model from setting the
    exit code of the process;
``requests``
    requests: what a verb is asked for, as a value.
"""
