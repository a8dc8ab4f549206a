"""Comparison of explorers in the same worlds, and in worlds that grow.

Each explorer is run under its own lighthouse unless the user names one, and every run is judged.
In a rooted map an explorer's cost is the mean over the places of its lighthouse; a map in which the
lighthouse of one explorer has no place is left out for all explorers.  In a family of worlds that
grow, a few members of each size are drawn from seeds, and isomorphic members count once.  Every
member has a name for the command line (``allworlds run algorithm1 --family torus:6x6 --seed 1``).

``entrants``
    the request; the entrants, which are explorers that are run in the same worlds; their costs; and
    the common base of both reports;
``comparison``
    the verb, and the runs in every world of a class;
``growth``
    families that grow, the runs in their members, and the costs by size;
``intervals``
    intervals of means and ratios, by Student's t on logarithms.
"""
