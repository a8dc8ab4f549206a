"""The error for an action that a world does not take.

It has a module of its own: a process that plays without a world loads nothing else of worlds.
"""


class IllegalAction(ValueError):
    """Raised for an action that is illegal in this world."""
