"""Built-in explorers: generator functions that depend only on the protocol.

A new built-in explorer needs a module in this package, and an entry in the table ``BUILT_IN`` of
the module ``explorer_table``.  The docstring of ``explorer_table`` lists the other modules.
"""
