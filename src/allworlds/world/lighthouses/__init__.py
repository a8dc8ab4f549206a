"""Lighthouses: what is marked in a world, and what of it can be sensed; one kind a module.

A new lighthouse is a module with a subclass of :class:`~allworlds.world.Lighthouse`, and an entry
of ``LIGHTHOUSES`` in the module ``kinds``.  What all kinds share is in the module ``base``, and
what a robot can sense of a lighthouse in a map in the module ``sensing``.
"""
