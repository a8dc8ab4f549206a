"""The verb ``mutants``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.output import emit


def mutants(
    *,
    edges: Annotated[
        int, opt.number(opt.SCOPE, "M", "Try worlds with at most M edges (1 to 4).")
    ] = 4,
    output: opt.LongOutput,
) -> int:
    """Example: allworlds mutants

    Try wrong explorers, weakened judges and broken enumerators, and say which check kills
    which at which smallest world.  Exit code 1: one survived.
    """
    import allworlds

    with listening(output) as listener:
        matrix = allworlds.mutants(edges=edges, listener=listener)
        listener.verdict(matrix)
    return emit(matrix, "mutants", output)
