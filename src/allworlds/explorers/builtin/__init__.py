"""Built-in explorers: generator functions that depend only on the protocol.

A new built-in explorer needs a module in this package and an entry of ``BUILT_IN`` in the module
``explorer_table``, whose docstring lists the other modules.
"""
