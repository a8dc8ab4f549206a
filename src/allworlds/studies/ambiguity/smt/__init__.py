"""Search by solvers for worlds that no motion tells apart; the only importer of z3 and pysat.

``question``
    what is searched for;
``formula``, ``one_world``, ``pair``
    a formula with names and meanings, and the two that are solved: one world, and twins;
``solvers``, ``cadical_child``
    who solves them;
``controls``
    the same formula with a part left out, which must have a model;
``decode``, ``witness``
    a model as two worlds, and what these must be whatever the formula says;
``rup``, ``lrat``
    checkers of proofs that there are none, our own solver's and another program's; twins that were
    found are checked by :mod:`allworlds.world.bisimulation`;
``twin_search``, ``result``
    the search, and what it has found: plain values.
"""
