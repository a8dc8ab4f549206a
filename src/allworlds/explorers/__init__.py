"""Explorers: the built-in ones, and the loading of the user's.

``builtin``
    the explorers that come with the package;
``loading``
    names of explorers; any explorer found by its name, and as a check speaks of it;
``sources``
    the part of a request that names one; names that are nearly those of one; the files of its code,
    their digest, and its line;
``program``
    a program in any language behind a pipe;
``shared_library``
    explorers in shared libraries; ``allworlds.h`` is the interface, and its own manual;
``languages``
    the languages of skeletons, which are explorers to begin with, in the folder ``skeletons``.
"""
