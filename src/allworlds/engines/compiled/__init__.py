"""The compiled engine: what the kernel is asked, and what becomes of its rows.

``requests``
    what the kernel is asked, and what it cannot do;
``tallies``
    built-in explorers: its rows into tallies;
``stretches``
    foreign explorers, many runs at a time;
``agreement``
    whether it is to be believed: it is compared with the Python engine;
``sizes``
    from which size on it is used.
"""
