"""The exact worst and best cost of explorers over all worlds and all schedules.

``one_world``
    one world, readably; also a sequence of choices that attains the worst cost;
``search``
    every world of a class, with the compiled engine, and what is reported;
``dearest``
    that engine, and what it brings;
``of_runs``
    the same of any explorer, by playing its runs.
"""

from allworlds.worst_case.of_runs import RunsReport, RunsRow
from allworlds.worst_case.one_world import EverySchedule
from allworlds.worst_case.search import WorstReport, WorstRow, merged_worst, worst

__all__ = [
    "EverySchedule",
    "RunsReport",
    "RunsRow",
    "WorstReport",
    "WorstRow",
    "merged_worst",
    "worst",
]
