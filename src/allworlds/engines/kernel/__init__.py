"""The kernel: the compiled code of the engines.

Each compiled program has a twin: readable Python code that gives the same answers, but is much
slower.  A program and its twin share no code; their answers are compared.  Compiled code holds the
lock of the Python interpreter only at its start and its end, so that several threads can work at
the same time.

``engine``: the functions that Python calls, for built-in and for users' explorers.
``runs``, ``laws``, ``code``: the loop over the runs of a unit; their laws; canonical codes.
``worlds``: the list of all maps with the places of their lighthouses; the number of maps.
``algorithm1``: the built-in explorers, with the functions that a user's explorer in C has.
``library_player``: the player of explorers that users have compiled into shared libraries.
``demand_driven``: a check of Algorithm 1 in worlds that are made while the robot walks.
``schedules``: the worst and the best cost of a world over all schedules.
``capabilities``: the names and the limits of the kernel, without compiled code.
``arrays``: the requests to the compiled code and its results; the arrays that it works on.
``compiling``: compilation, and instructions that numba lacks, such as calls by address.

Other modules import this package only inside of functions, because the first use compiles for some
seconds, and later uses load the compiled code.
"""
