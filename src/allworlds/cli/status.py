"""The verb ``status``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import emit


def status(
    run: Annotated[str, typer.Argument(metavar="DIR", help="A run directory.")],
    *,
    output: opt.OutputGroup,
) -> int:
    """Example: allworlds status shard-0

    How far a run directory is, also while somebody adds to it: units, worlds, rate, and what was
    met.
    """
    import allworlds

    return emit(allworlds.status(run), "status", output)
