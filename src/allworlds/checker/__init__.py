"""The check: every world of a class, one explorer, a verdict with its scope.

``options``
    the arguments that the functions ``check``, ``fuzz`` and ``run`` share;
``exhaustive``
    level by level to a report;
``job``
    what an engine is to do;
``engines``
    **the** table of engines;
``sizes``
    from which size on that is the compiled one;
``compiled``, ``questions``, ``agreement``
    the compiled one: its rows into tallies, what it is asked, and whether it is to be believed;
``stretches``
    the same for foreign explorers, many runs at a time;
``guessing``
    how long it will take;
``gate``
    what a complete check must have met: every world, and certain events;
``keeping``
    a check as a run directory knows it;
``corpus``
    findings of earlier checks, which are tried first;
``ending``
    how a job comes to its end;
``report``
    the verdict with its scope;
``single``, ``replaying``
    one world at a time;
``dearest``
    the dearest run of every size, played again.
"""

from allworlds.checker.corpus import UserCorpus
from allworlds.checker.dearest import dearest_runs, world_at
from allworlds.checker.ending import (
    Completed,
    Disagreed,
    Ending,
    Interrupted,
    Stopped,
    ending_of,
)
from allworlds.checker.engines import ENGINES, ReadyEngine, engine_for, why_not_compiled
from allworlds.checker.exhaustive import check, estimate, merged_check
from allworlds.checker.gate import Cell, count_gate
from allworlds.checker.guessing import TimeEstimate
from allworlds.checker.job import Job
from allworlds.checker.options import (
    CheckOptions,
    ManyRunsOptions,
    RunOptions,
    refuse_others,
    rules_for,
)
from allworlds.checker.replaying import Replay, replay
from allworlds.checker.report import Report
from allworlds.checker.single import SingleRun, run, single_run, worlds
from allworlds.checker.sizes import WALKED_FROM

__all__ = [
    "ENGINES",
    "WALKED_FROM",
    "Cell",
    "CheckOptions",
    "Completed",
    "Disagreed",
    "Ending",
    "Interrupted",
    "Job",
    "ManyRunsOptions",
    "ReadyEngine",
    "Replay",
    "Report",
    "RunOptions",
    "SingleRun",
    "Stopped",
    "TimeEstimate",
    "UserCorpus",
    "check",
    "count_gate",
    "dearest_runs",
    "ending_of",
    "engine_for",
    "estimate",
    "merged_check",
    "refuse_others",
    "replay",
    "rules_for",
    "run",
    "single_run",
    "why_not_compiled",
    "world_at",
    "worlds",
]
