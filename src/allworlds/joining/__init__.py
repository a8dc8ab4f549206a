"""Run directories put to use: joined to one report, or looked at while they grow.

``merging``
    the report of all shards, by the verb's own code with nothing left to do;
``standing``
    how far a run directory is.
"""

from allworlds.joining.merging import MergedReport, merge
from allworlds.joining.standing import Standing, status

__all__ = ["MergedReport", "Standing", "merge", "status"]
