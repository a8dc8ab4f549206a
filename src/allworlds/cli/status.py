"""The verb ``status``."""

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

    How far a run directory is, also while somebody adds to it: units, worlds, rate, and what was
    met.
    """
    return emit(allworlds.status(run), "status", output)
