"""The verb ``grow``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import ensure_all_writable, write_files
from allworlds.cli.output import emit


def grow(
    explorers: opt.Explorers = None,
    *,
    programs: opt.Programs,
    families: Annotated[
        str,
        opt.option(
            opt.SCOPE,
            "F,F,...",
            "Of lattice, torus, strip, dense (without 10% of its edges), cubic, regular:D, random "
            "(twice as many edges as vertices), bouquet, lollipop:D, prism, thick:D, cover.",
            "--family",
        ),
    ],
    to: Annotated[int, opt.number(opt.SCOPE, "M", "At most M edges.")] = 400,
    worlds: Annotated[int, opt.number(opt.SCOPE, "K", "Worlds of each size.")] = 3,
    seed: Annotated[
        int, opt.number(opt.SCOPE, "S", "Of the first world of a size; the others have the next.")
    ] = 1,
    lighthouse: opt.LighthouseName = None,
    rules: opt.Rules,
    effort: opt.Effort,
    csv: opt.CsvFile = None,
    plot: Annotated[
        str | None,
        opt.option(
            opt.OUTPUT,
            "FILE",
            "Draw the costs too, as SVG; needs the extra 'figures'.",
            show_default=False,
        ),
    ] = None,
    output: opt.LongOutput,
) -> int:
    """Example: allworlds grow algorithm1 greedy --family lattice,torus --to 100

    Cost by size on families of large worlds, with fitted exponents.  Every run is judged, and
    every world has a name that gives it back.  Exit code 0: no law is broken, 1: one is.
    """
    import allworlds
    from allworlds.reports import ensure_drawable

    files = {"csv": csv, "plot": plot}
    if plot is not None:
        ensure_drawable()
    ensure_all_writable(files)
    many = opt.many_runs("maps", lighthouse, rules, effort)
    with listening(output) as listener:
        report = allworlds.grow(
            *programs.after(explorers),
            families=families.split(","),
            to=to,
            worlds=worlds,
            seed=seed,
            listener=listener,
            **many,
        )
        listener.verdict(report)
    write_files("grow", report, files)
    return emit(report, "grow", output, workers=effort.count)
