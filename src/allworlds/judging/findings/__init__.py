"""Findings: a refuting run as a value.

``finding``
    a world, an explorer, its run there, and the law that it broke; as a file holds it, too.
"""
