"""Runs: which there are, played, judged and added up; nothing here survives an explorer.

``scope``
    what is to be checked: a class of worlds, all of it or a part, and the rules;
``units``
    the pieces of work into which it is cut;
``examiner``
    one run, played and judged;
``examination``
    all runs of a unit; **the** loop of the exhaustive check;
``tally``
    counts that can be added up in any order, and the smallest findings.
"""

from allworlds.runs.examination import Examination, Examines, LocalExamination
from allworlds.runs.examiner import Examiner, Outcome, make_finding
from allworlds.runs.scope import (
    DEFAULT_EDGES,
    Coverage,
    Sample,
    Schedule,
    Scope,
    Shard,
    Whole,
    a_schedule,
    a_shard,
)
from allworlds.runs.tally import Row, Tally
from allworlds.runs.units import GivenWorlds, NumberedRun, Placed, Unit, Worlds, numbered_runs

__all__ = [
    "DEFAULT_EDGES",
    "Coverage",
    "Examination",
    "Examiner",
    "Examines",
    "GivenWorlds",
    "LocalExamination",
    "NumberedRun",
    "Outcome",
    "Placed",
    "Row",
    "Sample",
    "Schedule",
    "Scope",
    "Shard",
    "Tally",
    "Unit",
    "Whole",
    "Worlds",
    "a_schedule",
    "a_shard",
    "make_finding",
    "numbered_runs",
]
