"""The kernel: compiled engines with the answers of their twins, orders of magnitude faster.

Each is compared with a readable twin that shares no code with it.  They hold the interpreter's
lock only to start and to end, so that threads share the work.

``engine``: the door, plain numbers in and out; users' runs, laid out and judged.
``runs``, ``laws``, ``code``: every run of a unit, played or read from its log, judged and tallied.
``worlds``: maps one after the other, with lighthouses, or their numbers.
``algorithm1``: built-in explorers, behind the C interface of all explorers.
``library_player``: runs of users' explorers, played by a library.
``demand_driven``: the check of Algorithm 1 in which a world is decided where the robot looks.
``schedules``: the worst and the best cost of a world over all schedules.
``capabilities``: what the kernel knows and has room for, without compiled code.
``arrays``, ``compiling``: requests, sums, arrays in memory; compilation, calls by address.

This package is imported where it is used: the first use compiles for some seconds, later ones
load what was compiled.
"""
