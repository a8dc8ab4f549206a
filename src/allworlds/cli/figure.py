"""The verb ``figure``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import ensure_all_writable
from allworlds.cli.output import emit


def figure(
    name: Annotated[
        str,
        typer.Argument(
            metavar="1|2|3|bounds",
            help="Twins, one pass of Algorithm 1, the cost in graphs with holes; or the exact "
            "worst cases beside the bound.",
        ),
    ],
    *,
    out: Annotated[
        str | None,
        opt.option(
            opt.OUTPUT,
            "FILE",
            "The picture: .svg, .png or .pdf; the data go beside it as .csv "
            "[default: figure-NAME.svg].",
            show_default=False,
        ),
    ] = None,
    worlds: Annotated[
        int | None,
        opt.number(opt.SCOPE, "K", "Graphs of each size, for 3 [default: 30].", show_default=False),
    ] = None,
    seed: Annotated[
        int | None,
        opt.number(
            opt.SCOPE, "S", "Of the first graph of a size, for 3 [default: 1].", show_default=False
        ),
    ] = None,
    edges: Annotated[
        int | None,
        opt.number(opt.SCOPE, "M", "At most M edges, for bounds [default: 6].", show_default=False),
    ] = None,
    effort: opt.Effort,
    output: opt.LongOutput,
) -> int:
    """Example: allworlds figure 2 --out pass.svg

    A figure of the paper, drawn from runs that were judged or from a proof that was checked, and
    its data as CSV; needs the extra 'figures'.  Exit code 0: what is drawn is so, 1: it is not.
    """
    import allworlds
    from allworlds.figures import files_of

    ensure_all_writable({str(i): str(path) for i, path in enumerate(files_of(name, out))})
    with listening(output) as listener:
        report = allworlds.figure(
            name,
            out=out,
            worlds=worlds,
            seed=seed,
            edges=edges,
            workers=effort.count,
            time_limit=effort.time_limit,
            memory=effort.memory,
            listener=listener,
        )
        listener.verdict(report)
    return emit(report, "figure", output, workers=effort.count)
