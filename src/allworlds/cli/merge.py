"""The verb ``merge``."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.events import listening
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.inputs import Argument


def merge(
    runs: Annotated[list[str], Argument("", "DIR...", "One a shard.", repeated=True)],
    *,
    output: LongOutputGroup,
) -> int:
    """Example: allworlds merge shard-0 shard-1

    Join the run directories of all shards of a job to the report that the job would have made by
    itself: counts and witnesses are judged over all of them.  Exit code 75: a part is missing,
    else that of the job.
    """
    with listening(output) as listener:
        report = allworlds.merge(*runs, listener=listener)
        listener.verdict(report)
    return emit(report, "merge", output)
