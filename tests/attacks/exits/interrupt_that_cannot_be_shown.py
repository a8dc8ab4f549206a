"""A module whose import raises a BaseException; to show it as text raises KeyboardInterrupt.

verdict: refused
says: which cannot be shown
"""


class Odd(BaseException):
    def __str__(self):
        raise KeyboardInterrupt


raise Odd
