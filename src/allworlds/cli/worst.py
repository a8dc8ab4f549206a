"""The verb ``worst``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import Progress, emit


def worst(
    *,
    edges: opt.Edges = None,
    map_class: opt.MapClassName = "maps",
    transit: Annotated[
        str,
        typer.Option(
            metavar="shortest|simple",
            help="How the robot goes to the next edge: on a shortest or on any simple path.",
            rich_help_panel=opt.RULES,
        ),
    ] = "simple",
    workers: Annotated[
        str, typer.Option(metavar="N|auto", rich_help_panel=opt.EFFORT, help="Threads.")
    ] = "auto",
    as_json: opt.Json = False,
    quiet: opt.Quiet = False,
) -> int:
    """Example: allworlds worst --edges 5

    The exact worst and best cost of Algorithm 1 over all worlds and over every schedule:
    every choice of edge, order of hypotheses and path.  Exit code 0: answered, 1: a schedule
    breaks a law, 70: the replay of a row disagrees.
    """
    from allworlds.worst_case import worst as run_worst

    with Progress(quiet=quiet) as progress:
        report = run_worst(
            edges=edges,
            map_class=map_class,
            transit=transit,
            workers=opt.worker_count(workers),
            listener=progress,
        )
    emit(report, "worst", as_json=as_json)
    return report.exit_code
