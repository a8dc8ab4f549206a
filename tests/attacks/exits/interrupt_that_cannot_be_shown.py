"""The same with what is no Exception, and with a name that is no text either.

verdict: refused
says: which cannot be shown
"""


class Odd(BaseException):
    def __str__(self):
        raise KeyboardInterrupt


raise Odd
