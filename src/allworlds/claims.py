"""The names that the file ``claims.py`` of a paper's ledger imports.

See ``allworlds ledger`` and ``allworlds init --ledger``.  A ledger lists claims, sentences of the
paper that can be checked; ``claims.py`` has a function for each.  The function takes a
:class:`Means`, and the bounds in ``ledger.toml`` as keywords.  It returns a :class:`Found` or a
:class:`NotChecked`::

    def map_and_pose(means, *, edges):
        return of_check(check("algorithm1", edges=edges, workers=means.workers))

Text that a claim's function prints goes to stderr, and the function cannot end the process.  A
claim that takes less than half a second is checked twice, and must have the same outcome both
times.  If a claim needs a package that is not installed, it counts as not checked.
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
