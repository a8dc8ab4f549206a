"""The verb ``merge`` on the command line."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.events import listening
from allworlds.cli.files import Files
from allworlds.cli.options import LongOutputGroup
from allworlds.cli.output import emit
from allworlds.inputs import Argument


def merge(
    runs: Annotated[
        list[str], Argument("", "DIR...", "The run directories, one for each shard.", repeated=True)
    ],
    *,
    files: Files,
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
    files.write("merge", report)
    return emit(report, "merge", output)
