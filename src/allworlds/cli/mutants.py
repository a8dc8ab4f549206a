"""The verb ``mutants``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import emit


def mutants(
    *,
    edges: Annotated[
        int,
        typer.Option(
            parser=opt.integer, metavar="M", help="Try worlds with at most M edges (1 to 4)."
        ),
    ] = 4,
    as_json: opt.Json = False,
) -> int:
    """Example: allworlds mutants

    Try wrong explorers, weakened judges and broken enumerators, and say which check kills
    which at which smallest world.  Exit code 1: one survived.
    """
    from allworlds.mutation import mutants as try_mutants

    matrix = try_mutants(edges=edges)
    emit(matrix, "mutants", as_json=as_json)
    return matrix.exit_code
