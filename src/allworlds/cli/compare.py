"""The verb ``compare``."""

from __future__ import annotations

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.files import PageFile, ensure_all_writable, write_files
from allworlds.cli.output import emit


def compare(
    explorers: opt.Explorers = None,
    *,
    programs: opt.Programs,
    bounds: opt.Bounds,
    drawn: opt.Family,
    lighthouse: opt.LighthouseName = None,
    rules: opt.Rules,
    effort: opt.Effort,
    csv: opt.CsvFile = None,
    page: PageFile,
    output: opt.LongOutput,
) -> int:
    """Example: allworlds compare algorithm1 greedy --edges 4

    Explorers side by side on the same worlds, each under its own lighthouse; the first is
    compared with each other one, in each rooted map by the mean over the lighthouse's places.
    Every run is judged.  Exit code 0: no law is broken, 1: one is.
    """
    import allworlds

    files = {"csv": csv}
    ensure_all_writable(files)
    page.ensure_writable()
    with listening(output) as listener:
        report = allworlds.compare(
            *programs.after(explorers),
            listener=listener,
            edges=bounds.edges,
            vertices=bounds.vertices,
            family=drawn.family,
            holes=drawn.holes,
            seed=drawn.seed,
            **opt.many_runs(bounds.map_class, lighthouse, rules, effort),
        )
        listener.verdict(report)
    write_files("compare", report, files)
    page.write("compare", report)
    return emit(report, "compare", output, workers=effort.count)
