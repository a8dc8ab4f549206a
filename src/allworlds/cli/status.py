"""The verb ``status`` on the command line."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.options import OutputGroup
from allworlds.cli.output import emit
from allworlds.inputs import Argument


def status(
    run: Annotated[str, Argument("", "DIR", "A run directory.")],
    *,
    output: OutputGroup,
) -> int:
    """Example: allworlds status shard-0

    Progress of a run directory, also while a job adds to it: units, worlds, rate, and findings.
    """
    return emit(allworlds.status(run), "status", output)
