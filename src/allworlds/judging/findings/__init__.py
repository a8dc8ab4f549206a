"""Findings: runs that break a law, as values.

``finding``
    the world, the explorer, its run there, and the broken law; also as the content of a file.
"""
