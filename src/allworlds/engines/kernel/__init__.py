"""The kernel: compiled engines that give the answers of their twins, but much faster.

Each engine is compared with a readable twin that shares no code with it.  An engine holds the
interpreter's lock only at its start and its end, so that threads share the work.

``engine``: the interface to Python, by plain numbers; also for runs that users' explorers play.
``runs``, ``laws``, ``code``: every run of a unit, played or read from its log, judged and counted.
``worlds``: lists maps with the places of their lighthouses, and counts maps.
``algorithm1``: the built-in explorers, behind the C interface of all explorers.
``library_player``: runs of users' explorers, played by a library.
``demand_driven``: the check of Algorithm 1 that decides a dart of a world once it is crossed.
``schedules``: the worst and the best cost of a world over all schedules.
``capabilities``: the names and the limits of the kernel, without compiled code.
``arrays``: the requests to the engines and their results, and the arrays of compiled code.
``compiling``: compilation, and instructions that numba lacks, such as calls by address.

Other modules import this package only inside of functions, because the first use compiles for some
seconds, and later uses load the compiled code.
"""
