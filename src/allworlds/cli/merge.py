"""The verb ``merge``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.output import emit


def merge(
    runs: Annotated[list[str], typer.Argument(metavar="DIR...", help="One a shard.")],
    *,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds merge shard-0 shard-1

    Join the run directories of all shards of a job to the report that the job would have made by
    itself: counts and witnesses are judged over all of them.  Exit code 75: a part is missing,
    else that of the job.
    """
    import allworlds

    with listening(output) as listener:
        report = allworlds.merge(*runs, listener=listener)
        listener.verdict(report)
    return emit(report, "merge", output)
