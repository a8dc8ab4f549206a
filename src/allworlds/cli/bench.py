"""The verb ``bench``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import emit


def bench(
    *,
    edges: Annotated[
        int,
        typer.Option(
            parser=opt.integer, metavar="M", help="The level that the compiled engines do."
        ),
    ] = 7,
    rounds: Annotated[
        int,
        typer.Option(
            parser=opt.integer, metavar="R", help="How often each contender takes its turn."
        ),
    ] = 3,
    peer: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME[@M]=COMMAND",
            help="Another program that walks every world with M edges (default: those of "
            "--edges); repeatable.",
            show_default=False,
        ),
    ] = None,
    as_json: opt.Json = False,
) -> int:
    """Example: allworlds bench --edges 7 --peer 'lazy=./lazy 1 7'

    Measure this program's engines and others side by side, in turns; ratios with their
    spread.
    """
    from allworlds.benching import bench as run_bench

    report = run_bench(edges=edges, rounds=rounds, peers=peer or ())
    emit(report, "bench", as_json=as_json)
    return report.exit_code
