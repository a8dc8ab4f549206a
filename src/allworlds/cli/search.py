"""The verb ``search``."""

from __future__ import annotations

import re
from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import Progress, emit
from allworlds.inputs import InputError, show


def search(
    *,
    info: Annotated[
        str,
        typer.Option(
            metavar="INFO",
            help="What is sensed besides degrees: none, position, compass or directional.",
            rich_help_panel=opt.SCOPE,
        ),
    ],
    max_vertices: Annotated[
        int,
        typer.Option(
            parser=opt.integer, metavar="N", help="At most N vertices.", rich_help_panel=opt.SCOPE
        ),
    ],
    max_edges: Annotated[
        int,
        typer.Option(
            parser=opt.integer, metavar="M", help="At most M edges.", rich_help_panel=opt.SCOPE
        ),
    ],
    map_class: opt.MapClassName = "maps",
    degree_marked: Annotated[
        int | None,
        typer.Option(
            parser=opt.integer,
            metavar="D",
            help="Degree of the start's vertex.",
            rich_help_panel=opt.SCOPE,
        ),
    ] = None,
    degree_others: Annotated[
        int | None,
        typer.Option(
            parser=opt.integer,
            metavar="D",
            help="Degree of every other vertex.",
            rich_help_panel=opt.SCOPE,
        ),
    ] = None,
    motions: Annotated[
        str | None,
        typer.Option(metavar="K,K,...", help="A walk from the start.", rich_help_panel=opt.SCOPE),
    ] = None,
    percepts: Annotated[
        str | None,
        typer.Option(
            metavar="P,P,...",
            help="What it senses after each motion: 3A (degree 3, marker absent) or 4P (present).",
            rich_help_panel=opt.SCOPE,
        ),
    ] = None,
    solver: Annotated[
        str | None,
        typer.Option(
            metavar="PATH",
            help="A CaDiCaL 2 or later, in place of z3; it writes the proofs too.",
            rich_help_panel=opt.EFFORT,
        ),
    ] = None,
    time_limit: opt.TimeLimit = None,
    out: Annotated[
        str | None,
        typer.Option(
            metavar="DIR",
            help="For formulas and proofs (default: a new temporary directory).",
            rich_help_panel=opt.OUTPUT,
            show_default=False,
        ),
    ] = None,
    as_json: opt.Json = False,
    quiet: opt.Quiet = False,
) -> int:
    """Example: allworlds search --info position --class simple --max-vertices 4 --max-edges 6

    Find two different worlds that no motion tells apart, or show that there are none.  Exit
    code 0: answered, 3: the time was over, 4: no world exists within the bounds.
    """
    from allworlds.smt import search as run_search

    result = run_search(
        info=info,
        map_class=map_class,
        max_vertices=max_vertices,
        max_edges=max_edges,
        degree_marked=degree_marked,
        degree_others=degree_others,
        motions=_motions(motions),
        percepts=() if percepts is None else tuple(percepts.split(",")),
        solver=solver,
        out=out,
        time_limit=time_limit,
    )
    with Progress(quiet=quiet) as progress:
        for notice in result.notices:
            progress.notice(notice)
    emit(result, "search", as_json=as_json)
    return result.exit_code


def _motions(text: str | None) -> tuple[int, ...]:
    if text is None:
        return ()
    if not re.fullmatch(r"-?[0-9]{1,3}(,-?[0-9]{1,3})*", text):
        raise InputError(f"motions {show(text)} are not integers of up to 3 digits with commas")
    return tuple(int(part) for part in text.split(","))
