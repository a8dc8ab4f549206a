"""Findings: a refuting run as a value, and its interpretation.

``finding``
    a world, an explorer, its run there, and the law that it broke; as a file holds it, too; the
    walk of its log in the world, the same walk in a wrong answer, and where they diverge.
"""
