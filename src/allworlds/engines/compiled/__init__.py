"""The compiled engine: requests to the kernel, and tallies of its rows.

``obstacles``
    the checks that it cannot do, and why;
``requests``
    requests to the kernel;
``tallies``
    built-in explorers: its rows into tallies;
``stretches``
    users' explorers, many runs at a time;
``users_engine``, ``users_kernel``
    the engine of both, for workers, and what it loads there;
``agreement``
    its comparison with the Python engine, before it is believed;
``sizes``
    the sizes from which on it is used.
"""
