"""Names for the ``claims.py`` of a paper: see ``allworlds ledger`` and ``init --ledger``.

The function of a claim takes :class:`Means`, and the bounds of ``ledger.toml`` as keywords; it
returns a :class:`Found` or a :class:`NotChecked`::

    def map_and_pose(means, *, edges):
        return of_check(check("algorithm1", edges=edges, workers=means.workers))

The prints of a claim's function go to stderr, and it cannot end the process.  A claim that takes
less than half a second is checked twice, and must have the same outcome both times.  A claim that
needs a package that is not installed counts as not checked.
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
