"""The compiled engine: requests to the kernel, and tallies of its rows.

``obstacles``
    the checks that it cannot do, and why;
``requests``
    requests to the kernel;
``tallies``
    its rows into tallies; the engine of built-in explorers;
``agreement``
    the comparison of that engine with the Python one, before it is believed;
``sizes``
    the sizes from which on it is used.
"""
