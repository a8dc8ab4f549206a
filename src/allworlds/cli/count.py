"""The verb ``count``."""

from __future__ import annotations

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.output import emit


def count(*, bounds: opt.ExtentGroup, output: opt.LongOutputGroup) -> int:
    """Example: allworlds count --edges 6

    Enumerate every rooted map of a class, count, and compare the counts with an independent
    source.
    """
    import allworlds

    with listening(output) as listener:
        census = allworlds.count(
            edges=bounds.edges,
            vertices=bounds.vertices,
            map_class=bounds.map_class,
            listener=listener,
        )
        listener.verdict(census)
    return emit(census, "count", output)
