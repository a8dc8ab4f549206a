"""Explorers in shared libraries: the C interface, from the caller's side.

``allworlds.h``
    the interface, which is its own manual;
``header``
    the text of it;
``guarded_memory``
    memory with a page behind it that cannot be written;
``library``
    a library, loaded and checked;
``native``
    the episodes of a library as an explorer's.

Only processes that may run users' code load a library.
"""
