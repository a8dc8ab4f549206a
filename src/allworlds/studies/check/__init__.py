"""The check: every world of a class, one explorer, a verdict with its scope.

``requests``
    what ``check`` and its like are asked for, as values;
``exhaustive``
    level by level to a report;
``time_estimate``
    how long it will take;
``shielding``
    any explorer, made right;
``given_worlds``
    worlds of the user's own, in place of all;
``gate``
    what a complete check must have met: every world, and certain events;
``tally_sweep``
    what it shares with other studies of one explorer in many worlds;
``run_identity``
    explorers and rules as a run directory knows them;
``known_findings``
    findings of earlier checks, which are tried first;
``confirmation``
    findings, played again in fresh processes;
``report``
    the verdict with its scope;
``shared_files``
    files that hold an explorer, and code that judges it;
``most_expensive``
    the most expensive run of every size, played again.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.check.confirmation import Confirmation as Confirmation
    from allworlds.studies.check.exhaustive import check as check, estimate as estimate
    from allworlds.studies.check.known_findings import UserCorpus as UserCorpus
    from allworlds.studies.check.report import (
        CheckReport as CheckReport,
        GateCell as GateCell,
        count_gate as count_gate,
        most_expensive_runs as most_expensive_runs,
    )
    from allworlds.studies.check.requests import (
        CheckRequest as CheckRequest,
        ManyRuns as ManyRuns,
        ManyWorlds as ManyWorlds,
        SharedFile as SharedFile,
        shared_file as shared_file,
    )
    from allworlds.studies.check.shielding import shield as shield
    from allworlds.studies.check.tally_sweep import (
        TallySweep as TallySweep,
        record_of as record_of,
        rules_known as rules_known,
        rules_record as rules_record,
        subject_of_record as subject_of_record,
    )
    from allworlds.studies.check.time_estimate import Guess as Guess, TimeEstimate as TimeEstimate
else:
    open_door(__name__)
