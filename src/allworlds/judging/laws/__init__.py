"""The judge: an answer and a log against the truth, law by law.

The judge takes values of :mod:`allworlds.maps` and :mod:`allworlds.protocol` and knows neither the
inside of a world nor any explorer.

``law_table``
    **the** table of the laws, and each as a function of a finished run with the truth beside it;
``folding``, ``bounds``
    the parts of laws: the folded log, the bounds.
"""
