"""The verb ``compare``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli.events import answered
from allworlds.cli.files import PageFile, ensure_all_writable, write_files
from allworlds.cli.options import CsvFile, LongOutputGroup
from allworlds.cli.output import emit
from allworlds.inputs import OUTPUT, InputError, Option
from allworlds.studies.compare import CompareRequest


def compare(
    request: CompareRequest,
    *,
    csv: CsvFile = None,
    plot: Annotated[
        str | None,
        Option(
            OUTPUT,
            "FILE",
            "With --to: draw the costs too, as SVG; needs the extra 'figures'.",
        ),
    ] = None,
    page: PageFile,
    output: LongOutputGroup,
) -> int:
    """Example: allworlds compare algorithm1 greedy --edges 4

    Explorers side by side on the same worlds, each under its own lighthouse; the first is
    compared with each other one, in each rooted map by the mean over the lighthouse's places.
    With --to one or more explorers in worlds that grow: cost by size, with fitted exponents, as in
    allworlds compare algorithm1 greedy --family lattice,torus --to 100.
    Every run is judged.  Exit code 0: no law is broken, 1: one is.
    """
    from allworlds.reports import ensure_drawable
    from allworlds.studies.compare import compared

    if plot is not None:
        if request.to is None:
            raise InputError(f"plot {plot} has no effect without --to")
        ensure_drawable()
    if request.to is not None and page.html is not None:
        raise InputError(f"html {page.html} has no effect with --to; give --csv or --plot")
    files = {"csv": csv, "plot": plot}
    ensure_all_writable(files)
    page.ensure_writable()
    report = answered(compared, request, output)
    write_files("compare", report, files)
    page.write("compare", report)
    return emit(report, "compare", output, workers=request.workers)
