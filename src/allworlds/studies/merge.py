"""Run directories that are joined."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

from allworlds.engines.limits import ListenerOptions
from allworlds.engines.progress import Listener
from allworlds.engines.run_directory import merged
from allworlds.engines.sweep import Sweep
from allworlds.engines.swept_report import RowOptions
from allworlds.engines.units import WHOLE
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import Argument, takes_fields
from allworlds.protocol.user_code import as_recorded
from allworlds.version import __version__


class MergeRequest(RowOptions, ListenerOptions):
    """Request of ``merge``: the run directories, and the rows that are wanted."""

    runs: Annotated[
        Sequence[str | Path],
        Argument("", "DIR...", "The run directories, one for each shard.", repeated=True),
    ]


def sweep_of(verb: str) -> type[Sweep[Any, Any]]:
    """The class of what goes through the units of a verb that a run directory keeps."""
    match verb:
        case "check":
            from allworlds.studies.check.exhaustive import CheckSweep

            return CheckSweep
        case "fuzz":
            from allworlds.studies.fuzz import FuzzSweep

            return FuzzSweep
        case "compare":
            from allworlds.studies.compare.comparison import SameWorlds

            return SameWorlds
        case "worst":
            from allworlds.studies.worst.all_worlds import SchedulesSweep

            return SchedulesSweep
        case "count":
            from allworlds.studies.count import CountSweep

            return CountSweep
        case "ambiguity census":
            from allworlds.studies.ambiguity.marked_worlds import CensusSweep

            return CensusSweep
    raise LookupError(verb)


def _merged(request: MergeRequest) -> Any:
    runs = request.runs
    with merged(runs) as (identity, records):
        if identity.version != __version__:
            raise InputError(
                f"run directory {show(str(runs[0]))} is of version {show(identity.version)}, not "
                f"{show(__version__)}"
            )
        kind = sweep_of(identity.verb)
        with as_recorded(identity.code):
            sweep = kind.known(identity, WHOLE, request.listener)
            if request.by is not None:
                sweep.list_by(request.by)
            return sweep.merged(records)


@takes_fields(MergeRequest, several="runs", answered=_merged)
def merge(*runs: str | Path, by: str | None = None, listener: Listener | None = None) -> Any:
    """Merge the shards of a job, which were kept in run directories, into one report.

    Counts are compared with their source, and witnesses looked for, as if it had been one job.
    No explorer is needed, and none is run: findings were confirmed by those who found them.

    Returns:
        the report that the verb would have made by itself.

    Raises:
        InputError: if they are not of one job, overlap, or are damaged.
        Gap: if something is missing.
    """
    return _merged(MergeRequest(runs=runs, by=by, listener=listener))
