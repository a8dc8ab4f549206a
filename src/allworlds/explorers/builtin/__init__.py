"""Explorers: generator functions that are written against the protocol alone.

A new built-in explorer is a module of this package and an entry of ``BUILT_IN`` in its module
``explorer_table``, which tells of the others too.
"""
