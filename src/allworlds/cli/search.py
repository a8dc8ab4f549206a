"""The verb ``search``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import PageFile
from allworlds.cli.output import emit
from allworlds.cli.values import motion_list


def search(
    *,
    lighthouse: Annotated[
        str,
        opt.option(
            opt.SCOPE,
            "KIND",
            "What is sensed besides degrees: none, position, compass or directional.",
        ),
    ],
    vertices: Annotated[int, opt.number(opt.SCOPE, "N", "At most N vertices.")],
    edges: Annotated[int, opt.number(opt.SCOPE, "M", "At most M edges.")],
    map_class: opt.MapClassName = "maps",
    degree_marked: Annotated[
        int | None, opt.number(opt.SCOPE, "D", "Degree of the start's vertex.")
    ] = None,
    degree_others: Annotated[
        int | None, opt.number(opt.SCOPE, "D", "Degree of every other vertex.")
    ] = None,
    motions: Annotated[
        str | None, opt.option(opt.SCOPE, "K,K,...", "A walk from the start.")
    ] = None,
    percepts: Annotated[
        str | None,
        opt.option(
            opt.SCOPE,
            "P,P,...",
            "What it senses after each motion: 3A (degree 3, marker absent) or 4P (present).",
        ),
    ] = None,
    solver: Annotated[
        str | None,
        opt.option(
            opt.EFFORT,
            "PATH",
            "A CaDiCaL 2 or later, in place of z3; it writes the proofs too.",
        ),
    ] = None,
    time_limit: opt.TimeLimit = None,
    out: Annotated[
        str | None,
        opt.option(
            opt.OUTPUT,
            "DIR",
            "For formulas and proofs (default: a new temporary directory).",
            show_default=False,
        ),
    ] = None,
    page: PageFile,
    output: opt.LongOutput,
) -> int:
    """Example: allworlds search --lighthouse position --class simple --vertices 4 --edges 6

    Find two different worlds that no motion tells apart, or show that there are none.  Exit
    code 0: answered, 3: the time was over, 4: no world exists within the bounds.
    """
    import allworlds

    page.ensure_writable()

    with listening(output) as listener:
        result = allworlds.search(
            lighthouse=lighthouse,
            map_class=map_class,
            vertices=vertices,
            edges=edges,
            degree_marked=degree_marked,
            degree_others=degree_others,
            motions=motion_list(motions),
            percepts=() if percepts is None else tuple(percepts.split(",")),
            solver=solver,
            out=out,
            time_limit=time_limit,
            listener=listener,
        )
        for notice in result.notices:
            listener.notice(notice)
        listener.verdict(result)
    seconds = [searched.seconds for searched in result.searched]
    page.write("search", result)
    return emit(result, "search", output, level_seconds=seconds)
