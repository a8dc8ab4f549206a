"""The check: every world of a class, one explorer, a verdict with its scope.

``requests``
    what ``check`` and its like are asked for, as values;
``exhaustive``
    level by level to a report;
``time_estimate``
    how long it will take;
``gate``
    what a complete check must have met: every world, and certain events;
``run_identity``
    a check as a run directory knows it;
``known_findings``
    findings of earlier checks, which are tried first;
``ending``
    how a job comes to its end;
``report``
    the verdict with its scope;
``most_expensive``
    the most expensive run of every size, played again.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.check.ending import (
        Completed as Completed,
        Disagreed as Disagreed,
        Ending as Ending,
        Interrupted as Interrupted,
        Stopped as Stopped,
        ending_of as ending_of,
    )
    from allworlds.studies.check.exhaustive import (
        check as check,
        estimate as estimate,
        merged_check as merged_check,
    )
    from allworlds.studies.check.gate import GateCell as GateCell, count_gate as count_gate
    from allworlds.studies.check.known_findings import UserCorpus as UserCorpus
    from allworlds.studies.check.most_expensive import (
        most_expensive_runs as most_expensive_runs,
        world_at as world_at,
    )
    from allworlds.studies.check.report import CheckReport as CheckReport
    from allworlds.studies.check.requests import (
        CheckRequest as CheckRequest,
        EstimateRequest as EstimateRequest,
        ManyRuns as ManyRuns,
        ManyWorlds as ManyWorlds,
    )
    from allworlds.studies.check.time_estimate import Guess as Guess, TimeEstimate as TimeEstimate
else:
    open_door(__name__)
