"""The verb ``worst``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import PageFile
from allworlds.cli.output import emit
from allworlds.cli.values import shard_numbers, worker_count


def worst(
    explorer: opt.Explorer = None,
    *,
    command: opt.Exec = None,
    native: opt.Native = None,
    edges: Annotated[
        int | None,
        opt.number(
            opt.SCOPE,
            "M",
            "At most M edges (default: 5 of algorithm1, 3 of others).",
            show_default=False,
        ),
    ] = None,
    map_class: opt.MapClassName = "maps",
    transit: Annotated[
        str | None,
        opt.option(
            opt.RULES,
            "shortest|simple",
            "How Algorithm 1 goes to the next edge: on a shortest or on any simple path "
            "[default: simple].",
            show_default=False,
        ),
    ] = None,
    lighthouse: opt.LighthouseName = None,
    shard: opt.ShardText = "0/1",
    workers: opt.Workers = "auto",
    run: opt.RunDirectory = None,
    dask: opt.DaskAddress = None,
    page: PageFile,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds worst --edges 5

    The exact worst and best cost of an explorer over all worlds and over every schedule; of
    Algorithm 1 every choice of edge, order of hypotheses and path.  Exit code 0: answered,
    1: a schedule breaks a law, 70: counts, replays or engines disagree.
    """
    import allworlds

    page.ensure_writable()

    threads = worker_count(workers)
    with listening(output) as listener:
        report = allworlds.worst(
            opt.explorer_name(explorer, command, native),
            edges=edges,
            map_class=map_class,
            transit=transit,
            lighthouse=lighthouse,
            shard=shard_numbers(shard),
            run=run,
            dask=dask,
            workers=threads,
            listener=listener,
        )
        listener.verdict(report)
    page.write("worst", report)
    return emit(report, "worst", output, workers=threads)
