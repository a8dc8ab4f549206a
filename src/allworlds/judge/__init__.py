"""The judge: an answer and a log against the truth, law by law.

It takes values of :mod:`allworlds.maps` and :mod:`allworlds.protocol` and knows neither the
inside of a world nor any explorer.  Each law is a function from a :class:`Case` to a
:class:`Violation` or None; the table :data:`LAWS` names them in the order of precedence.

``case``
    what every law is given: a finished run with the truth beside it;
``laws``
    **the** table of the laws;
``invariants``, ``folding``, ``bounds``, ``ambiguity``
    what they rest on: S in the world, the folded log, the bounds, the quotient;
``second_opinion``
    another judge of answers, by graph isomorphisms, to be compared with.
"""

from allworlds.judge.ambiguity import ambiguity_law
from allworlds.judge.bounds import Bound, bound_named, paper_bound, printed_bound
from allworlds.judge.case import Case, Violation
from allworlds.judge.folding import Folded, fold
from allworlds.judge.laws import (
    LAWS,
    PRECEDENCE,
    Check,
    Checks,
    Law,
    Setting,
    bound_law,
    judge,
    map_law,
)
from allworlds.judge.second_opinion import same_map

__all__ = [
    "LAWS",
    "PRECEDENCE",
    "Bound",
    "Case",
    "Check",
    "Checks",
    "Folded",
    "Law",
    "Setting",
    "Violation",
    "ambiguity_law",
    "bound_law",
    "bound_named",
    "fold",
    "judge",
    "map_law",
    "paper_bound",
    "printed_bound",
    "same_map",
]
