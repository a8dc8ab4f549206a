"""Lighthouses: the marks and directions in a world, and their percepts.

A new lighthouse is a subclass of :class:`~allworlds.world.Lighthouse`, and an entry of
``LIGHTHOUSES`` in the module ``kinds``.  The module ``base`` has the attributes and methods that
all kinds share; ``own_kind`` loads the classes of users.
"""
