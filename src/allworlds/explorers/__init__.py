"""Explorers: the built-in ones, and the loading of the user's.

``builtin``
    the explorers that come with the package, one a module;
``names``
    names of explorers, what is known by a name alone, and those that are nearly one;
``functions``
    a function found by its name, with the fewest imports;
``loading``
    any explorer found by its name, in a process that may run users' code, and as a check speaks
    of it;
``asked``
    the part of a request that names one;
``sources``
    the files of its code: their digest, and the line of the explorer;
``program``
    a program in any language behind a pipe;
``shared_library``
    explorers in shared libraries: the C interface;
``skeletons``
    explorers to begin with, in several languages.
"""
