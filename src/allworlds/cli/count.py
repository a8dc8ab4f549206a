"""The verb ``count``."""

from __future__ import annotations

from allworlds.cli import options as opt
from allworlds.cli.output import Progress, emit


def count(*, bounds: opt.Bounds, output: opt.Output) -> int:
    """Example: allworlds count --edges 6

    Enumerate every rooted map of a class, count, and compare the counts with an independent
    source.
    """
    import allworlds

    with Progress(quiet=output.quiet) as progress:
        census = allworlds.count(
            edges=bounds.edges,
            vertices=bounds.vertices,
            map_class=bounds.map_class,
            listener=progress,
        )
    return emit(census, "count", output)
