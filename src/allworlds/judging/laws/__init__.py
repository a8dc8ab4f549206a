"""The laws, which compare an answer and a log with the truth.

The laws take values of :mod:`allworlds.maps` and :mod:`allworlds.protocol`, such as maps, logs and
answers.  Of a world they use only the map and the start; they use no explorer.

``law_table``
    **the** table of the laws; each is a function of a finished run and the truth;
``folding``, ``bounds``
    the folded log, and the bounds, which the laws ``folding`` and ``bound`` need.
"""
