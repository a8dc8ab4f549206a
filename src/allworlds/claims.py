"""The names that a user imports to write the claims of a paper.

A paper's ledger is a folder with two files; the verb ``ledger`` checks it, and ``init --ledger``
begins one.  ``ledger.toml`` lists *claims*, which are sentences of the paper that can be checked.
The user's own file ``claims.py`` has a function for each claim, and imports from this module,
``allworlds.claims``.  The function of a claim takes a :class:`Means`, which says how many workers
and how much work the function may use, and as keywords the bounds that ``ledger.toml`` gives for
this claim.  The function returns a :class:`Found` or a :class:`NotChecked`.  In this example
:func:`of_check` makes a :class:`Found` from the report of a check::

    def map_and_pose(means, *, edges):
        return of_check(check("algorithm1", edges=edges, workers=means.workers))

Text that the function prints goes to stderr, and the function cannot end the process.  A claim that
takes less than half a second is checked twice, and must have the same outcome both times.  A claim
that needs a package that is not installed counts as not checked.
"""

from allworlds.explorers.builtin.algorithm1 import Algorithm1
from allworlds.explorers.builtin.folding import FoldedLog
from allworlds.reports.drawing.layout import layout
from allworlds.studies.compare.intervals import mean_interval
from allworlds.studies.ledger import (
    Found,
    Means,
    NotChecked,
    Picture,
    Unfinished,
    of_check,
    truth,
)
from allworlds.studies.worst.every_schedule import EverySchedule

__all__ = [
    "Algorithm1",
    "EverySchedule",
    "FoldedLog",
    "Found",
    "Means",
    "NotChecked",
    "Picture",
    "Unfinished",
    "layout",
    "mean_interval",
    "of_check",
    "truth",
]
