"""Lighthouses: the marks and directions in a world, and their percepts; one kind a module.

A new lighthouse is a module with a subclass of :class:`~allworlds.world.Lighthouse`, and an entry
of ``LIGHTHOUSES`` in the module ``kinds``.  The module ``base`` has the parts that all kinds
share, and the module ``sensing`` the percepts of a robot.
"""
