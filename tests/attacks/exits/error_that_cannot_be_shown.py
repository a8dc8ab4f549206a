"""Raises, when it is imported, an error whose text is an error.

verdict: refused
says: which cannot be shown
"""


class Odd(Exception):
    def __str__(self):
        raise self


raise Odd
