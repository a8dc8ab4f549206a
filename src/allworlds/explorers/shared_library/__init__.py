"""Explorers in shared libraries: the C interface, from the caller's side.

``allworlds.h``
    the interface, which is its own manual;
``header``
    the text of it;
``guarded_memory``
    memory that nobody can write beyond;
``library``
    a library, loaded and looked at;
``native``
    its episodes as an explorer's.

Only processes that may run foreign code load a library.
"""
