"""Built-in explorers: generator functions that depend only on the protocol.

A new built-in explorer is a module of this package and an entry of ``BUILT_IN`` in its module
``explorer_table``, which lists the other modules.
"""
