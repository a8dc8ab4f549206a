"""The judge: an answer and a log against the truth, law by law.

It takes values of :mod:`allworlds.maps` and :mod:`allworlds.protocol` and knows neither the
inside of a world nor any explorer.  Each law is a function from a :class:`Case` to a
:class:`Violation` or None, and :data:`LAWS` names them in the order of precedence.
"""

from allworlds.judge.bounds import Bound, BoundError, bound_named, paper_bound
from allworlds.judge.case import Case, Violation
from allworlds.judge.laws import LAWS, PRECEDENCE, Law, Laws, judge

__all__ = [
    "LAWS",
    "PRECEDENCE",
    "Bound",
    "BoundError",
    "Case",
    "Law",
    "Laws",
    "Violation",
    "bound_named",
    "judge",
    "paper_bound",
]
