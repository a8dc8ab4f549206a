"""Runs: which there are, played, judged and added up.

``scope``
    what is to be checked: a class of worlds, all of it or a part, and the rules;
``units``
    the pieces of work into which it is cut;
``examiner``
    one run, judged, and what differs between two plays of it;
``examination``
    all runs of a unit; **the** loop of the exhaustive check;
``play``, ``twice``, ``here``
    a foreign explorer, which plays everything twice;
``tally``
    counts that can be added up in any order, and the smallest findings;
``costs``
    the same with the cost of every run.
"""

from allworlds.runs.costs import Costing, CostTally, MapKey, RunCost, key_of
from allworlds.runs.examination import (
    REPORT_EVERY,
    EnginesDisagree,
    Examination,
    Examines,
    InParts,
    OwnExamination,
)
from allworlds.runs.examiner import (
    LOST,
    Examiner,
    Outcome,
    Referee,
    name_run,
    nondeterministic,
)
from allworlds.runs.here import PlayersHere
from allworlds.runs.play import Record, Recorded, Stagehand
from allworlds.runs.scope import (
    DEFAULT_EDGES,
    Coverage,
    Sample,
    Schedule,
    Scope,
    a_schedule,
)
from allworlds.runs.tally import AtRun, Row, Tally, finding_kept, kept_finding
from allworlds.runs.twice import Earlier, OneRun, PlayedTwice, Players
from allworlds.runs.units import GivenWorlds, NumberedRun, Placed, Unit, Worlds, numbered_runs

__all__ = [
    "DEFAULT_EDGES",
    "LOST",
    "REPORT_EVERY",
    "AtRun",
    "CostTally",
    "Costing",
    "Coverage",
    "Earlier",
    "EnginesDisagree",
    "Examination",
    "Examiner",
    "Examines",
    "GivenWorlds",
    "InParts",
    "MapKey",
    "NumberedRun",
    "OneRun",
    "Outcome",
    "OwnExamination",
    "Placed",
    "PlayedTwice",
    "Players",
    "PlayersHere",
    "Record",
    "Recorded",
    "Referee",
    "Row",
    "RunCost",
    "Sample",
    "Schedule",
    "Scope",
    "Stagehand",
    "Tally",
    "Unit",
    "Worlds",
    "a_schedule",
    "finding_kept",
    "kept_finding",
    "key_of",
    "name_run",
    "nondeterministic",
    "numbered_runs",
]
