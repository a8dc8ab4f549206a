"""The verbs ``ambiguity census`` and ``ambiguity class``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import PageFile
from allworlds.cli.output import Progress, emit
from allworlds.cli.values import shard_numbers


def census(
    *,
    bounds: opt.Bounds,
    shard: opt.ShardText = "0/1",
    run: opt.RunDirectory = None,
    dask: opt.DaskAddress = None,
    output: opt.LongOutput,
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
    output: opt.Output,
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
