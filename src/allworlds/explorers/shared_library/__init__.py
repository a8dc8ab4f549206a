"""Explorers in shared libraries: the C interface, from the caller's side.

``allworlds.h``
    the interface, which is its own manual;
``library``
    a library, loaded and checked, and its episodes as an explorer's.

Only processes that may run users' code load a library.
"""
