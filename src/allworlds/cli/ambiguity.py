"""The verbs ``ambiguity twins``, ``class``, ``census`` and ``search``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import PageFile
from allworlds.cli.output import Progress, emit
from allworlds.cli.values import motion_list, shard_numbers


def twins(
    a: Annotated[str, typer.Argument(metavar="A", help=opt.WORLD)],
    b: Annotated[str, typer.Argument(metavar="B", help="Another one.")],
    *,
    lighthouse: opt.LighthouseOfWorld = "position",
    page: PageFile,
    output: opt.OutputGroup,
) -> int:
    """Example: allworlds ambiguity twins fig1-left fig1-right

    Can any motion tell two worlds apart?  The answer comes with the shortest motions that do,
    or with classes of darts that prove that none does.
    """
    import allworlds
    from allworlds.world import world_named

    page.ensure_writable()

    result = allworlds.twins(world_named(a, lighthouse), world_named(b, lighthouse))
    page.write("ambiguity twins", result)
    return emit(result, "ambiguity twins", output)


def census(
    *,
    bounds: opt.ExtentGroup,
    shard: opt.ShardText = "0/1",
    run: opt.RunDirectory = None,
    dask: opt.DaskAddress = None,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds ambiguity census --edges 5

    Classify every map with one marked vertex: which of them does no motion tell apart?  Twins
    are looked for inside the class only.
    """
    import allworlds

    with listening(output) as listener:
        result = allworlds.ambiguity.census(
            edges=bounds.edges,
            vertices=bounds.vertices,
            map_class=bounds.map_class,
            shard=shard_numbers(shard),
            run=run,
            dask=dask,
            listener=listener,
        )
        listener.verdict(result)
    return emit(result, "ambiguity census", output)


def class_(
    world: opt.WorldText,
    *,
    lighthouse: opt.LighthouseOfWorld = "position",
    limit: Annotated[
        int | None,
        opt.number(
            opt.EFFORT,
            "L",
            "List at most L worlds; size and poses are exact all the same [default: 1000].",
            show_default=False,
        ),
    ] = None,
    map_class: opt.MapClassName = "maps",
    page: PageFile,
    output: opt.OutputGroup,
) -> int:
    """Example: allworlds ambiguity class k4 --class simple

    Build every world that no motion tells from WORLD, and say why.
    """
    import allworlds
    from allworlds.world import world_named

    page.ensure_writable()

    result = allworlds.ambiguity.class_of(
        world_named(world, lighthouse),
        limit=allworlds.ambiguity.DEFAULT_LIMIT if limit is None else limit,
        map_class=map_class,
    )
    with Progress(quiet=output.quiet) as progress:
        if result.notice:
            progress.notice(result.notice)
    page.write("ambiguity class", result)
    return emit(result, "ambiguity class", output)


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
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds ambiguity search --lighthouse position --class simple --edges 6

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
    seconds = [searched.seconds for searched in result.levels]
    page.write("ambiguity search", result)
    return emit(result, "ambiguity search", output, level_seconds=seconds)
