"""Input from outside: checks of values, requests, and where these may be made.

``checks``
    checks of values, and the error that is the user's to mend; what keeps a model from setting the
    exit code of the process, and from taking the user's interrupt for its own error;
``nesting``
    the refusal of a check that another one causes;
``requests``
    requests: what a verb is asked for, as a value.
"""
