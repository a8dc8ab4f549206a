"""The verb ``compare``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.events import watched
from allworlds.cli.files import ensure_all_writable, write_files
from allworlds.cli.output import emit
from allworlds.maps.families import FORMS

Explorers = Annotated[
    list[str],
    typer.Argument(
        metavar="A B [C...]",
        help="Built-in names, module:attribute, path/to/file.py:attribute, entry points or "
        "exec:COMMAND; the first is compared with each other one.",
    ),
]


def compare(
    explorers: Explorers,
    *,
    bounds: opt.Bounds,
    family: Annotated[
        str | None, opt.option(opt.SCOPE, "F", f"In place of a class one world: {FORMS}.")
    ] = None,
    holes: Annotated[
        str | None,
        opt.option(
            opt.SCOPE,
            "P%",
            "Share of a family's edges to remove [default: none].",
            show_default=False,
        ),
    ] = None,
    seed: Annotated[int, opt.number(opt.SCOPE, "S", "For whatever is drawn of a family.")] = 0,
    lighthouse: opt.LighthouseName = None,
    rules: opt.Rules,
    effort: opt.Effort,
    csv: opt.CsvFile = None,
    html: Annotated[
        str | None,
        opt.option(
            opt.OUTPUT,
            "FILE",
            "Write a web page too, with the walks in the world that differs most.",
            show_default=False,
        ),
    ] = None,
    output: opt.Watched,
) -> int:
    """Example: allworlds compare algorithm1 greedy --edges 4

    Explorers side by side on the same worlds, each under its own lighthouse, compared in each
    rooted map by the mean over the lighthouse's places.  Every run is judged.  Exit code 0:
    no law is broken, 1: one is.
    """
    import allworlds

    files = {"csv": csv, "html": html}
    ensure_all_writable(files)
    with watched(output) as listener:
        report = allworlds.compare(
            *explorers,
            listener=listener,
            edges=bounds.edges,
            vertices=bounds.vertices,
            family=family,
            holes=holes,
            seed=seed,
            **opt.many_runs(bounds.map_class, lighthouse, rules, effort),
        )
        listener.verdict(report)
    write_files("compare", report, files)
    return emit(report, "compare", output, workers=effort.count)
