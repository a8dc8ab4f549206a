"""The verb ``compare``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import PageFile, ensure_all_writable, write_files
from allworlds.cli.output import emit
from allworlds.inputs import InputError


def compare(
    explorers: opt.Explorers = None,
    *,
    programs: opt.ProgramsGroup,
    bounds: opt.ExtentGroup,
    family: Annotated[
        str | None,
        opt.option(
            opt.SCOPE,
            "F[,F...]",
            f"One world of a family: {opt.FORMS}; with --to one or more families that grow: "
            "lattice, torus, strip, dense (without 10% of its edges), cubic, regular:D, random "
            "(twice as many edges as vertices), bouquet, lollipop:D, prism, thick:D, cover.",
            show_default=False,
        ),
    ] = None,
    holes: opt.Holes = None,
    seed: Annotated[
        int | None,
        opt.number(
            opt.SCOPE,
            "S",
            "For whatever is drawn of a family; with --to of the first world of a size, the others "
            "have the next [default: 0; with --to 1].",
            show_default=False,
        ),
    ] = None,
    to: Annotated[
        int | None,
        opt.number(opt.SCOPE, "M", "Worlds of the families up to M edges.", show_default=False),
    ] = None,
    worlds: Annotated[
        int | None,
        opt.number(
            opt.SCOPE, "K", "With --to: worlds of each size [default: 3].", show_default=False
        ),
    ] = None,
    lighthouse: opt.LighthouseName = None,
    rules: opt.RulesGroup,
    effort: opt.EffortGroup,
    csv: opt.CsvFile = None,
    plot: Annotated[
        str | None,
        opt.option(
            opt.OUTPUT,
            "FILE",
            "With --to: draw the costs too, as SVG; needs the extra 'figures'.",
            show_default=False,
        ),
    ] = None,
    page: PageFile,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds compare algorithm1 greedy --edges 4

    Explorers side by side on the same worlds, each under its own lighthouse; the first is
    compared with each other one, in each rooted map by the mean over the lighthouse's places.
    With --to one or more explorers in worlds that grow: cost by size, with fitted exponents, as in
    allworlds compare algorithm1 greedy --family lattice,torus --to 100.
    Every run is judged.  Exit code 0: no law is broken, 1: one is.
    """
    import allworlds
    from allworlds.reports import ensure_drawable

    if plot is not None:
        if to is None:
            raise InputError(f"plot {plot} has no effect without --to")
        ensure_drawable()
    if to is not None and page.html is not None:
        raise InputError(f"html {page.html} has no effect with --to; give --csv or --plot")
    files = {"csv": csv, "plot": plot}
    ensure_all_writable(files)
    page.ensure_writable()
    with listening(output) as listener:
        report = allworlds.compare(
            *programs.after(explorers),
            listener=listener,
            edges=bounds.edges,
            vertices=bounds.vertices,
            family=family,
            holes=holes,
            seed=seed,
            to=to,
            worlds=worlds,
            **opt.many_runs(bounds.map_class, lighthouse, rules, effort),
        )
        listener.verdict(report)
    write_files("compare", report, files)
    page.write("compare", report)
    return emit(report, "compare", output, workers=effort.count)
