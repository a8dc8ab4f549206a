"""The verb ``optimum``."""

from __future__ import annotations

from typing import Annotated

from allworlds.cli import options as opt
from allworlds.cli.events import listening
from allworlds.cli.output import emit


def optimum(
    *,
    edges: Annotated[
        int, opt.number(opt.SCOPE, "M", "Worlds with 1, 2, ... up to M edges (at most 6).")
    ] = 3,
    time_limit: Annotated[
        float | None,
        opt.option(opt.EFFORT, "S", "Seconds for the search of each row.", parser=opt.seconds),
    ] = None,
    output: opt.LongOutputGroup,
) -> int:
    """Example: allworlds optimum --edges 4

    The fewest traversals with which an explorer that knows the number of edges can map the
    worst world, by minimax over all worlds with every bearing, with its strategy; beside it the
    worst cost of every built-in explorer.  Exit code 0: answered, 3: the time was up, 70: the
    strategy, followed in every world, disagrees.
    """
    import allworlds

    with listening(output) as listener:
        report = allworlds.optimum(edges=edges, time_limit=time_limit, listener=listener)
        listener.verdict(report)
    return emit(report, "optimum", output)
