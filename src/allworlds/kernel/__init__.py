"""Compiled engines for the class ``maps``: the same answers, orders of magnitude further.

Each is compared with a readable twin that shares no code with it.

``bits``
    sets of small numbers as bit masks;
``tables``
    what the engines look up: bounds, the gluing rule; mutants are damaged tables;
``walk``
    the demand-driven check of Algorithm 1: a world is decided only where the robot looks;
``thorough``
    every finished map, one after the other, held to the judge's laws;
``gluing``
    every rooted map, counted by vertices and genus;
``schedules``
    the worst and the best cost of a world over all schedules;
``pool``
    units of work in threads, for the checker.

Nothing here is imported before it is needed: the first use compiles for some seconds, later
ones load what was compiled.
"""
