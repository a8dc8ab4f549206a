"""Explorers: the built-in ones, and the loading of the user's.

``builtin``
    the explorers that come with the package, one a module;
``names``
    names of explorers, and what is known by a name alone;
``subject``
    an explorer as a check speaks of it;
``loading``, ``functions``
    its code, found by its name, in a process that may run users' code; a function, with the fewest
    imports;
``asked``
    the part of a request that names one;
``spelling``
    names that are nearly those of an explorer;
``digest``
    a digest of an explorer's code, independent of its name;
``source_line``
    the file and the line of one;
``program``, ``program_lines``
    a program in any language behind a pipe, and the lines between;
``command_words``
    the words of its command: an interpreter and its script;
``shared_library``
    explorers in shared libraries: the C interface;
``skeletons``
    explorers to begin with, in several languages.
"""
