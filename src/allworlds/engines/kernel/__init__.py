"""The kernel: compiled engines with the answers of their twins, orders of magnitude faster.

Each is compared with a readable twin that shares no code with it.  They hold the interpreter's
lock only to start and to end, so that threads share the work.

``engine``, ``rows``
    the door: plain numbers in, plain rows out;
``runs``, ``published``, ``folding``
    the judge: every run of every map of a class, played, judged and tallied;
``gluing``, ``worlds``, ``lighthouses``
    the worlds: maps, finished one after the other, with every lighthouse;
``algorithm1``
    explorers, each behind the C interface of all explorers;
``batches``, ``logs``
    users' explorers: runs laid out, their logs judged, many at a time;
``native``
    libraries, played in worlds and against records;
``stretch``, ``memory_arrays``
    the memory of a batch, plain and as arrays;
``library_player``, ``users``
    a library that plays batches; the compiling of what judges, in another process;
``demand_driven``
    the demand-driven check of Algorithm 1: a world is decided only where the robot looks;
``schedules``, ``schedule_costs``
    the worst and the best cost of a world over all schedules, and its door;
``counting``
    the numbers of maps, by vertices and faces;
``capabilities``
    the explorers and lighthouses that it knows, and the sizes that it has room for;
``records``, ``tables``, ``names``, ``law_numbers``
    the records in memory, the tables, and the names of small numbers;
``compiling``, ``calls``, ``bits``, ``code``
    compilation, C functions called by their addresses, sets as bit masks, codes.

This package is imported where it is used: the first use compiles for some seconds, later ones
load what was compiled.
"""
