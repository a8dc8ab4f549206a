"""The judge: an answer and a log against the truth, law by law.

The judge takes values of :mod:`allworlds.maps` and :mod:`allworlds.protocol` and knows neither the
inside of a world nor any explorer.  Each law is a function from a :class:`~allworlds.judging.Case`
to a :class:`~allworlds.judging.Violation` or None; the table ``LAWS`` names them in the order of
precedence.

``case``
    the input of every law: a finished run with the truth beside it;
``law_table``
    **the** table of the laws;
``invariants``, ``folding``, ``bounds``, ``quotient_answers``
    the parts of laws: S in the world, the folded log, the bounds, the quotient.
"""
